"""What was changed on the vehicle survives the server, and no line of it can stop one."""

from datetime import UTC, datetime
from pathlib import Path

from bumpless_server.what_if.revisions import KEPT, Revision, Revisions


def revision(number: int) -> Revision:
    return Revision(
        revision=number,
        session="one",
        at=datetime(2026, 1, 1, tzinfo=UTC),
        author="Ada",
        reason="calmer switch",
        changes={"hover.lambda": [0.1, 0.2]},
        parameters={"hover": {"lambda": 0.2}},
    )


def test_they_are_read_again(tmp_path: Path) -> None:
    """Protects going back to what was flown with before a restart: newest first, no more than are shown."""
    kept = Revisions(tmp_path / "revisions.jsonl")
    kept.open()
    for number in range(KEPT + 5):
        kept.add(revision(number))
    again = Revisions(tmp_path / "revisions.jsonl")
    again.open()
    assert [one.revision for one in again.all()] == list(range(KEPT + 4, 4, -1))
    assert again.all()[0] == revision(KEPT + 4)


def test_a_strange_line_costs_only_itself(tmp_path: Path) -> None:
    """Protects from a file that a power cut or somebody else has left."""
    path = tmp_path / "revisions.jsonl"
    path.write_bytes(b'{"half": \n\xff\xfe\n[]\n' + revision(3).model_dump_json().encode() + b"\n")
    kept = Revisions(path)
    kept.open()
    assert [one.revision for one in kept.all()] == [3]


def test_a_disk_that_takes_no_more_stops_nobody(tmp_path: Path) -> None:
    """Protects the command: it was carried out, whatever becomes of its line."""
    kept = Revisions(tmp_path)  # a folder can't be written to
    kept.open()
    kept.add(revision(1))
    assert [one.revision for one in kept.all()] == [1]
