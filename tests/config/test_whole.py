"""A file is replaced by a whole one or stays as it was."""

import os
from pathlib import Path

import pytest

from bumpless.config.whole import NotWritten, whole, write_text


def test_what_stood_there_stays_until_the_new_one_is_whole(tmp_path: Path) -> None:
    """Protects: a full disk at a report or a vehicle file left half of the new one and nothing of the old."""
    path = tmp_path / "vehicle.toml"
    write_text(path, "old")

    def full() -> None:
        with whole(path) as partial:
            partial.write_text("half")
            raise OSError(28, "No space left on device")

    with pytest.raises(NotWritten) as told:
        full()
    assert str(told.value) == f"{path}: No space left on device"
    assert [one.name for one in tmp_path.iterdir()] == ["vehicle.toml"] and path.read_text() == "old"
    write_text(path, "new")
    assert path.read_text() == "new"


def test_what_is_no_file_is_not_replaced(tmp_path: Path) -> None:
    """Protects: `--out` naming a device or a pipe put a file in its place."""
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    with pytest.raises(NotWritten, match="is no ordinary file"):
        write_text(pipe, "x")
    with pytest.raises(NotWritten, match="is a folder"):
        write_text(tmp_path, "x")
    assert pipe.is_fifo() and not list(tmp_path.glob("*.part"))
    with pytest.raises(NotWritten, match="No such file or directory"):
        write_text(tmp_path / "nowhere" / "x", "x")
