"""What people say of runs, and a bin with a way back: the logs are never changed for it."""

from pathlib import Path

import pytest

from bumpless_server.runs.shelf import Shelf, Words


def shelf(folder: Path) -> Shelf:
    made = Shelf(folder / "words.json", folder / "bin")
    made.open()
    return made


def test_words_survive_a_restart_and_a_broken_file_is_no_end(tmp_path: Path) -> None:
    """Protects titles, tags and notes; empty words leave nothing behind."""
    words = Words("Calm sea", ("calm", "trial 3"), "It went well.")
    shelf(tmp_path).write("a", words)
    assert shelf(tmp_path).words("a") == words
    assert shelf(tmp_path).words("b") == Words()
    again = shelf(tmp_path)
    again.write("a", Words())
    assert (tmp_path / "words.json").read_text() == "{}"
    for text in ("{", "[]", '{"a": 1}'):
        (tmp_path / "words.json").write_text(text)
        assert shelf(tmp_path).words("a") == Words()


def test_a_run_comes_back_from_the_bin_as_it_was(tmp_path: Path) -> None:
    """Protects a record from a hand that slipped, and a new run from an old one of its name."""
    runs = tmp_path / "runs"
    runs.mkdir()
    log = runs / "a.mcap"
    log.write_bytes(b"log")
    bin_ = shelf(tmp_path)
    bin_.throw(log)
    assert not log.exists() and [path.stem for path in bin_.thrown()] == ["a"]
    assert bin_.take_back("a", runs) == log and log.read_bytes() == b"log"
    assert bin_.take_back("a", runs) is None
    bin_.throw(log)
    log.write_bytes(b"another")
    with pytest.raises(FileExistsError):
        bin_.take_back("a", runs)
    assert log.read_bytes() == b"another"
