"""Every request that changes something is written down, or says why it is not."""

from bumpless_server.access.deeds import DEEDS, ELSEWHERE, SILENT, deed_of
from bumpless_server.access.rights import READING, ROWS


def test_no_changing_request_is_forgotten() -> None:
    """Protects: presets, missions and alarms changed without a line in the audit; the next kind shall not."""
    tables = (DEEDS, ELSEWHERE, SILENT)
    changing = {(row.method, row.path) for row in ROWS if row.method not in {*READING, "WS"}}
    told = [key for table in tables for key in table]
    assert changing - set(told) == set(), "say in bumpless_server/access/deeds.py what these are called"
    assert sorted(told) == sorted({*told} & {(row.method, row.path) for row in ROWS})
    assert all(table.values() for table in tables)


def test_a_request_is_called_by_its_verb_and_the_names_in_its_path() -> None:
    """Protects: the line names what was changed, also where the route adds nothing."""
    assert deed_of("DELETE", "/api/presets/calm") == ("delete_preset", {"name": "calm"})
    assert deed_of("POST", "/api/alarms/a-1/shelve") == ("shelve_alarm", {"alarm": "a-1"})
    assert deed_of("GET", "/api/presets/calm") is None
    assert deed_of("PUT", "/api/missions/x/draft") is None
    assert deed_of("PUT", "/api/nowhere") is None
