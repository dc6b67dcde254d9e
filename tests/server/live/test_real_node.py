"""Server and real vehicle node together: what `bumpless serve` starts flies, is recorded and measured."""

import os
import signal
from collections.abc import Callable
from typing import Any

from bumpless import open_run
from bumpless.contract import bumpless_pb2 as pb
from bumpless.metrics import as_dict
from bumpless.runs.figures import OUTCOME
from bumpless.runs.summary import summarise
from bumpless_server.settings import Settings
from tests.server.serving import Running, serving

COMPILES_S = 600.0  # patience with a machine that has never compiled the control cycle


def alike(running: Running, run: str) -> bool:
    """Whether list, record, event and log tell one outcome, with all that belongs to it."""
    path = running.console.data.runs / f"{run}.mcap"
    found = open_run(path)
    event: Any
    (event,) = [m for topic, m in found.messages() if topic == "event" and getattr(m, "code", "") == OUTCOME]
    row, kept = running.http.get(f"/api/runs/{run}").json(), summarise(path)
    told = found.outcome
    assert (row["outcome"], row["outcome_reason"]) == (kept.outcome, kept.outcome_reason)
    assert (kept.outcome, kept.outcome_reason) == (told.ending, told.reason)
    assert event.text == told.sentence and event.details["basis"] == told.basis == "believed"
    running.until(lambda: event.text in [one["text"] for one in running.http.get("/api/events").json()])
    assert kept.metrics == as_dict(found.metrics)
    assert told.true_errors is None and told.believed_errors is not None and told.closest_m is not None
    return True


def test_a_real_mission_is_flown_recorded_and_measured_and_survives_the_nodes_death(
    make_settings: Callable[..., Settings],
) -> None:
    """The default node, the default mission: metrics are in the list and in the file; kill -9 is mended."""
    with serving(make_settings(node_command=())) as running:
        http, state = running.http, running.console.state
        running.until(lambda: state.latest("parameters") and state.latest("description"), COMPILES_S)
        run = http.post("/api/mission/start", json={"name": "docking"}).json()["run_id"]

        def flown(seconds: float) -> bool:
            status = state.latest("mission")
            return (
                isinstance(status, pb.MissionStatus) and status.run_id == run and status.elapsed_s > seconds
            )

        running.until(lambda: flown(1.5))
        assert http.post("/api/mission/abort").json()["accepted"]
        running.until(lambda: running.console.recorder.recording is None)
        row = http.get(f"/api/runs/{run}").json()
        assert (row["state"], row["dropped"]) == ("complete", 0)
        metrics = http.get(f"/api/runs/{run}/metrics").json()
        assert metrics["cycles"] >= 30 and metrics["missing_cycles"] == 0
        assert metrics["increment_violations"] == metrics["demand_step_violations"] == 0
        assert metrics == row["metrics"]
        assert row["outcome"] == "aborted" and alike(running, run)

        second = http.post("/api/mission/start", json={"name": "docking"}).json()["run_id"]
        running.until(lambda: (going := running.console.recorder.recording) and going.messages > 100)
        os.kill(running.console.supervisor.pid or 0, signal.SIGKILL)
        running.until(lambda: state.link == pb.LINK_STATE_LOST)
        running.until(lambda: running.console.recorder.recording is None)
        assert http.get(f"/api/runs/{second}").json()["state"] == "interrupted"
        assert http.get(f"/api/runs/{second}/metrics").json()["cycles"] > 0
        assert alike(running, second)
        running.until(lambda: state.link == pb.LINK_STATE_LIVE, COMPILES_S)
        assert http.get("/api/status").json()["node_restarts"] == 1
