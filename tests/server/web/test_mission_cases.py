"""Missions that were once flown without a word, through every door: command line, upload, check and start."""

import json
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from typer.testing import CliRunner

from bumpless_server.cli.main import app
from bumpless_server.settings import Settings
from tests.server.serving import Running, serving

CASE = """version: 1
name: case
vehicle: ts100
duration_s: 90
seed: 1
start: {position_ned_m: [0, 0, 2.0], heading_deg: 0, speed_mps: 0.7}
legs:
  - {to_ned_m: [10, 0, 2.0], speed_mps: 0.7}
  - {to_ned_m: [24.5, 0, 2.3], speed_mps: 0.7}
target: {position_ned_m: [26, 0, 2.3], heading_deg: 0, standoff_m: 1.5}
"""
FAR = CASE.replace("[24.5, 0, 2.3]", "[5000, 0, 2.0]").replace("[26, 0, 2.3]", "[5001.5, 0, 2.0]")
ABEAM = CASE + "environment:\n  current_ned_mps: [0, %g, 0]\n"
BACK = CASE.replace("duration_s: 90", "duration_s: 150").replace(
    "[10, 0, 2.0]", "[22, 0, 2.0], speed_mps: 0.7}\n  - {to_ned_m: [0, 0, 2.0]"
)
ROOT = Path(__file__).parents[3]
# case -> text, hard codes, soft codes that are among others, (field, value, line) of one that is named
CASES: dict[str, tuple[str, list[str], set[str], tuple[str, str, int]]] = {
    "three_digits": (CASE.replace("heading_deg: 0, s", "heading_deg: 045, s"), [], set(), ("", "", 0)),
    "crlf": (CASE.replace("\n", "\r\n"), [], set(), ("", "", 0)),
    "too_far": (FAR, ["too_far"], set(), ("duration_s", "90", 4)),
    "depth_typo": (
        CASE.replace("[26, 0, 2.3]", "[26, 0, 23]"), [], {"target_depth"}, ("target.position_ned_m", "", 10),
    ),
    "there_and_back": (BACK, [], {"seen_early", "leg_near_dock", "short_of_time"}, ("duration_s", "", 4)),
    "abeam_1_cm": (ABEAM % 0.01, [], {"current_hard_to_hold"}, ("target.heading_deg", "", 10)),
    "abeam_10_cm": (
        ABEAM % 0.1, ["current_not_holdable"], set(), ("target.heading_deg", "0", 10),
    ),
    "start_at_the_dock": (
        CASE.replace("[0, 0, 2.0], heading", "[23, 0, 2.3], heading").replace("[10, 0, 2.0]", "[10, 9, 2.0]"),
        ["starts_too_near"], set(), ("start.position_ned_m", "[23, 0, 2.3]", 6),
    ),
}  # fmt: skip


@pytest.fixture
def server(make_settings: Callable[..., Settings]) -> Iterator[Running]:
    """A server without a vehicle."""
    with serving(make_settings(manage_node=False)) as running:
        yield running


def test_each_case_is_told_the_same_at_every_door(server: Running, tmp_path: Path) -> None:
    """Protects: what can't work passed by one door; a refusal names file, field, value, rule and line."""
    paths = []
    for name, (text, *_) in CASES.items():
        paths.append(str(tmp_path / f"{name}.yaml"))
        Path(paths[-1]).write_bytes(text.encode())
    printed = json.loads(CliRunner().invoke(app, ["validate", "--json", *paths]).stdout)
    for (name, (text, hard, soft, (field, value, line))), told in zip(CASES.items(), printed, strict=True):
        codes = {
            kind: [f["code"] for f in told["findings"] if f["severity"] == kind] for kind in ("hard", "soft")
        }
        assert codes["hard"] == hard and soft <= set(codes["soft"]), name
        assert told["ok"] == (not hard) and told["problems"] == []
        if field:
            assert next(f["line"] for f in told["findings"] if f["path"] == field) == line
        uploaded = server.http.post("/api/missions", params={"name": name}, content=text.encode())
        assert uploaded.status_code == 201 and uploaded.json()["sha256"] == told["sha256"]
        stored = server.http.get(f"/api/missions/{name}/findings").json()
        sent = server.http.post("/api/missions/check", content=text.encode()).json()
        assert stored["findings"] == sent["findings"] == told["findings"]
        if hard:
            refused = server.http.post("/api/mission/start", json={"name": name})
            assert refused.status_code == 422
            problem = refused.json()["problems"][0]
            assert (problem["file"], problem["field"], problem["value"], problem["line"]) == (
                f"{name}.yaml", field, value, line,
            )  # fmt: skip
            assert problem["rule"].startswith(told["findings"][0]["reason"])


def test_what_is_no_utf_8_or_no_mission_is_named_at_every_door(server: Running, tmp_path: Path) -> None:
    """Protects: a Latin-1 comment or another program's plan was an unreadable file with no reason."""
    latin = "# Kurs 45\xb0\n".encode("latin-1") + CASE.encode()
    plan = (ROOT / "tests/server/plan/foreign/harbour.plan").read_bytes()
    for name, data, said in (
        ("latin1.yaml", latin, "byte 0xb0 at offset 9"),
        ("sub.plan", plan, "QGroundControl"),
    ):
        (tmp_path / name).write_bytes(data)
        printed = CliRunner().invoke(app, ["validate", "--json", str(tmp_path / name)])
        assert printed.exit_code == 1 and said in json.loads(printed.stdout)[0]["problems"][0]["rule"]
        flown = CliRunner().invoke(app, ["run", str(tmp_path / name), "--out", str(tmp_path / "no.mcap")])
        assert flown.exit_code != 0 and said in flown.output and not (tmp_path / "no.mcap").exists()
        refused = server.http.post("/api/missions", params={"name": "other"}, content=data)
        assert refused.status_code == 422 and said in refused.json()["problems"][0]["rule"]
    taken = server.http.post("/api/missions/import", params={"file_name": "sub.plan"}, content=plan)
    assert taken.status_code == 200 and taken.json()["kind"] == "a QGroundControl plan"
    unread = server.http.post("/api/missions/import", params={"file_name": "latin1.csv"}, content=latin)
    assert unread.status_code == 422 and unread.json()["problems"][0]["rule"]
