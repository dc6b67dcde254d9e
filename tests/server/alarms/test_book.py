"""The life of an alarm: until its cause has gone and somebody has seen it, whatever comes first."""

from pathlib import Path

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.alarms.book import Book

ALARM, WARNING = pb.SEVERITY_ALARM, pb.SEVERITY_WARNING


def test_what_is_over_stays_until_it_was_seen() -> None:
    """Protects: a node that died showed a banner for four seconds, and then all was green."""
    book = Book()
    assert book.raise_("node_died", ALARM, "It died.", 10)
    assert not book.raise_("node_died", ALARM, "It died.", 11), "a cause that holds is no news"
    assert book.return_("node_died", 12)
    (alarm,) = book.open()
    assert (alarm.raised_ns, alarm.returned_ns, alarm.acknowledged_ns) == (10, 12, 0)
    assert book.acknowledge(alarm.id, "Ada", 13)
    assert book.open() == [] and book.history()[0].acknowledged_by == "Ada"


def test_what_was_seen_stays_while_its_cause_holds() -> None:
    """Protects: acknowledging is not mending."""
    book = Book()
    book.raise_("saturated", WARNING, "At its bound.", 10)
    assert book.acknowledge(book.open()[0].id, "Ada", 11)
    assert len(book.open()) == 1
    assert book.return_("saturated", 12) and book.open() == []


def test_a_cause_that_comes_back_is_to_be_seen_anew() -> None:
    """Protects: one line that counts, not a flood; and no acknowledgement for what came after it."""
    book = Book()
    for now in (10, 20, 30):
        book.raise_("target_lost", WARNING, f"Lost at {now}.", now)
        book.return_("target_lost", now + 5)
    (alarm,) = book.open()
    assert (alarm.count, alarm.text, alarm.raised_ns) == (3, "Lost at 30.", 30)
    book.raise_("other", ALARM, "Worse.", 40)
    assert [a.code for a in book.open()] == ["other", "target_lost"]
    assert not book.acknowledge("nobody", "Ada", 50)


def test_alarms_survive_the_server(tmp_path: Path) -> None:
    """Protects what nobody has seen from a restart, and the history with it; a broken file is no end."""
    path = tmp_path / "alarms.json"
    book = Book(path)
    book.raise_("leak", ALARM, "Water.", 10, {"where": "bow"})
    book.raise_("link_lost", ALARM, "Gone.", 11)
    book.return_("link_lost", 12)
    book.acknowledge(next(a.id for a in book.open() if a.code == "link_lost"), "Ada", 13)
    again = Book(path)
    assert again.open() == book.open() and again.history() == book.history()
    path.write_text("{")
    assert Book(path).open() == []


def test_the_most_urgent_stands_first_whatever_came_last() -> None:
    """Protects five priorities, as ISA-18.2 has them: an actuator at its bound never hides a dead node."""
    book = Book()
    for now, (code, severity) in enumerate(
        [("node_died", ALARM), ("recorder_failed", ALARM), ("tracking_depth", WARNING)]
        + [("saturated", WARNING), ("clock_offset", WARNING)]
    ):
        book.raise_(code, severity, code, now)
    assert [a.priority for a in book.open()] == [1, 2, 3, 4, 5]
    assert book.open()[0].message().priority == 1
