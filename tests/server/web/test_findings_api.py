"""Findings over HTTP and on the command line: the same ones, and what can't work is not started unread."""

import json
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from typer.testing import CliRunner

from bumpless.config.mission import missions_folder
from bumpless_server.cli.main import app
from bumpless_server.settings import Settings
from tests.server.serving import Running, serving

DOCKING = (missions_folder() / "docking.yaml").read_bytes()
ABEAM = DOCKING.split(b"\nenvironment:")[0] + b"\nenvironment:\n  current_ned_mps: [0, 0.1, 0]\n"


@pytest.fixture
def alone(make_settings: Callable[..., Settings]) -> Iterator[Running]:
    """A server without a vehicle."""
    with serving(make_settings(manage_node=False)) as server:
        yield server


def test_what_cannot_work_is_started_only_by_who_has_read_why(running: Running) -> None:
    """Protects: a mission that fails by all that is known does not start with a click or a script's line; the
    refusal brings each reason with its place and the changes that mend it; who has read it may."""
    running.http.put("/api/missions/abeam", content=ABEAM).raise_for_status()
    refused = running.http.post("/api/mission/start", json={"name": "abeam"})
    assert refused.status_code == 422
    found = refused.json()["findings"][0]
    assert found["severity"] == "hard" and found["path"] == "target.heading_deg" and found["line"] > 1
    assert found["mends"] and found["mends"][0]["path"].startswith("target.")
    assert refused.json()["problems"][0]["field"] == "target.heading_deg"
    started = running.http.post("/api/mission/start", json={"name": "abeam", "despite_findings": True})
    assert started.status_code == 200 and started.json()["accepted"]


def test_a_mend_mends(alone: Running) -> None:
    """Protects: the change that a finding offers takes the finding away."""
    found = alone.http.post("/api/missions/check", content=ABEAM).json()
    assert not found["ok"]
    mend = next(m for m in found["findings"][0]["mends"] if m["path"] == "target.approach")
    mended = ABEAM.replace(b"  standoff_m:", f"  approach: {mend['value']}\n  standoff_m:".encode())
    after = alone.http.post("/api/missions/check", content=mended).json()
    assert after["problems"] == [] and after["ok"]


def test_api_and_command_line_say_the_same(alone: Running, tmp_path: Path) -> None:
    """Protects: one verdict, one hash and one shape, for good, hopeless and unreadable files."""
    files = {
        "good": DOCKING,
        "abeam": ABEAM,
        "latin": b"# \xe9\n" + DOCKING,
        "bom": b"\xef\xbb\xbf" + DOCKING,
    }
    files["crlf"] = ABEAM.replace(b"\n", b"\r\n")
    paths = []
    for name, data in files.items():
        (alone.console.data.missions / f"{name}.yaml").write_bytes(data)
        (tmp_path / f"{name}.yaml").write_bytes(data)
        paths.append(str(tmp_path / f"{name}.yaml"))
    printed = json.loads(CliRunner().invoke(app, ["validate", "--json", *paths]).stdout)
    for name, told in zip(files, printed, strict=True):
        stored = alone.http.get(f"/api/missions/{name}/findings").json()
        sent = alone.http.post("/api/missions/check", content=files[name]).json()
        for one in (told, stored, sent):
            assert one.pop("file").endswith(".yaml")
            one.pop("warnings", None)
            for problem in one["problems"]:
                problem.pop("file")
        assert told == stored == sent
        listed = {m["name"]: m for m in alone.http.get("/api/missions").json()}[name]
        assert listed["sha256"] == told["sha256"] and listed["valid"] == (not told["problems"])


def test_every_file_is_answered_though_one_cannot_be_read(tmp_path: Path) -> None:
    """Protects: a script that validates a folder learns of all of it."""
    good = tmp_path / "good.yaml"
    good.write_bytes(DOCKING)
    shown = CliRunner().invoke(app, ["validate", "--json", str(tmp_path), str(tmp_path / "none"), str(good)])
    assert shown.exit_code == 1
    assert [one["ok"] for one in json.loads(shown.stdout)] == [False, False, True]
