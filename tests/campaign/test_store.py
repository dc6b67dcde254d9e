"""Results on disk."""

import pytest

from bumpless.campaign.flight import FlyNumbers
from bumpless.campaign.fly import fly_missing
from bumpless.campaign.store import PARTS, StoreError, opened


def test_a_folder_that_cannot_be_made_is_said(tmp_path, campaign):
    """Protects: --out below a file, or where nothing may be written, is a line and not a traceback."""
    (tmp_path / "file").write_text("")
    with pytest.raises(StoreError, match="cannot be written: Not a directory"):
        opened(tmp_path / "file" / "out", campaign(2), False).__enter__()


def test_resume_flies_exactly_what_is_missing(campaign, cluster, tmp_path):
    """Protects: a part that is there is not touched, every number is there once, rows are those of one go."""
    prepared = campaign(9)
    with opened(tmp_path, prepared, False) as kept:
        kept.add(FlyNumbers(prepared)([2, 3, 4]))
        part = next((tmp_path / PARTS).iterdir())
        before = part.stat().st_mtime_ns
    (tmp_path / PARTS / "00000007-00000008.part").write_bytes(b"cut off in the middle")
    paces = []
    with opened(tmp_path, prepared, True) as kept:
        fly_missing(prepared, kept, cluster, paces.append)
        table = kept.table()
    assert part.stat().st_mtime_ns == before
    assert table.column("number").to_pylist() == list(range(9))
    assert repr(table.to_pylist()) == repr(FlyNumbers(prepared)(range(9)))
    assert min(pace.stored for pace in paces) > 3
    assert (paces[-1].stored, paces[-1].total, paces[-1].left_s) == (9, 9, 0.0)


def test_a_flown_folder_needs_resume(campaign, tmp_path):
    """Protects: results are neither overwritten nor added to by mistake."""
    prepared = campaign(3)
    with opened(tmp_path, prepared, False) as kept:
        kept.add(FlyNumbers(prepared)([0]))
    with pytest.raises(StoreError, match="go on with --resume"), opened(tmp_path, prepared, False):
        pass


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ("docked: {range_m: 0.3}\n", "the campaign's declaration changed since"),
        (
            "parameters: {hover: {lambda: 0.3}}\n",
            "the campaign's declaration and the control parameters changed",
        ),
    ],
)
def test_a_changed_declaration_is_refused(campaign, tmp_path, more, said):
    """Protects: flights of two different campaigns never share a folder, with or without --resume."""
    with opened(tmp_path, campaign(3), False):
        pass
    with pytest.raises(StoreError, match=said), opened(tmp_path, campaign(3, more), True):
        pass


def test_changed_software_is_refused(campaign, tmp_path, monkeypatch):
    """Protects: flights of two states of the software are not mixed."""
    with opened(tmp_path, campaign(3), False):
        pass
    monkeypatch.setattr("bumpless.campaign.prepared.software", lambda: "9.9")
    with pytest.raises(StoreError, match="the software changed since"), opened(tmp_path, campaign(3), True):
        pass


def test_one_writer_at_a_time(campaign, tmp_path):
    """Protects: two commands on one folder would fly the same flights twice."""
    prepared = campaign(3)
    with opened(tmp_path, prepared, False):
        with pytest.raises(StoreError, match="in use"), opened(tmp_path, prepared, True):
            pass


def test_flights_stored_twice_are_noticed(campaign, tmp_path):
    """Protects: a folder changed by hand does not give a summary that counts a flight twice."""
    prepared = campaign(3)
    rows = FlyNumbers(prepared)([0, 1, 2])
    with opened(tmp_path, prepared, False) as kept:
        kept.add(rows)
        kept.add(rows[:2])
        with pytest.raises(StoreError, match="twice"):
            kept.numbers()
