"""Files put into the folder of runs: noticed once they stand still, and once each."""

from pathlib import Path

from bumpless_server.runs.watch import FolderWatch


def test_a_file_counts_when_it_stands_still(tmp_path: Path) -> None:
    """Protects from reading, and worse repairing, what is still being copied."""
    told: list[set[str]] = []
    watch = FolderWatch(tmp_path, told.append)
    watch.look()
    path = tmp_path / "a.mcap"
    for data in (b"1", b"12", b"123"):
        path.write_bytes(data)
        watch.look()
    assert told == []
    watch.look()
    watch.look()
    assert told == [{"a.mcap"}]
    path.unlink()
    watch.look()
    assert told == [{"a.mcap"}, {"a.mcap"}]


def test_a_fault_of_who_is_told_ends_nothing(tmp_path: Path) -> None:
    """Protects the watch: the next file is noticed all the same."""
    told: list[set[str]] = []

    def fail(names: set[str]) -> None:
        told.append(names)
        raise OSError("disk")

    watch = FolderWatch(tmp_path, fail)
    for name in "ab":
        (tmp_path / f"{name}.mcap").write_bytes(b"")
        watch.look()
        watch.look()
    assert told == [{"a.mcap"}, {"b.mcap"}]
