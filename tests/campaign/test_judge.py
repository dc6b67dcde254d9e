"""A campaign's rows are what `bumpless run` says of the same flight: there is one judge."""

from pathlib import Path

import numpy as np
import pytest

import bumpless
from bumpless.campaign.figures import NUMBERS, figures
from bumpless.campaign.flight import FlyNumbers, Row
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.read import parse_campaign
from bumpless.campaign.replay import replayed
from bumpless.contract.bumpless_pb2 import Metrics
from bumpless.metrics import Ending
from bumpless.runs.run import Run

ABEAM = {"duration_s": "160", "environment": "{current_ned_mps: [0, 0.01, 0]}"}
# case -> how it ends, mission, what is changed of it; nobody aborts or interrupts a campaign's flight
ENDS = {
    "docked": (Ending.DOCKED, "docking", {}),
    "captured": (Ending.DOCKED, "remus_docking", {}),
    "held": (Ending.HELD, "docking", {"duration_s": "66"}),
    "waved off": (Ending.WAVED_OFF, "docking_refused", {}),
    "time over": (Ending.TIME_OVER, "docking", {"duration_s": "20"}),
    "collided": (Ending.COLLIDED, "s4_mdca_bumpless", ABEAM),
}
HEAD = """version: 1
name: one
missions: [{mission}]
count: 1
seed: 7
draw:
  noise: 1.5
  lag: 1.1
"""


def campaign_of(name: str, changed: dict[str, str], folder: Path) -> Prepared:
    """A campaign of one flight of a shipped mission with other numbers at its top."""
    text = (bumpless.config.mission.missions_folder() / f"{name}.yaml").read_text()
    lines = [line for line in text.splitlines() if line.partition(":")[0] not in changed]
    (folder / "m.yaml").write_text(
        "\n".join([*lines, *(f"{key}: {value}" for key, value in changed.items())])
    )
    return parse_campaign(HEAD.format(mission="m.yaml"), folder=folder)


@pytest.fixture(scope="module", params=list(ENDS))
def judged(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Row, Run]:
    """For each way to end: its word, a campaign's row, and the run of the same mission, plant and seed."""
    ending, name, changed = ENDS[request.param]
    prepared = campaign_of(name, changed, tmp_path_factory.mktemp("one"))
    mission, vehicle, parameters, alteration = replayed(prepared, 0)
    run = bumpless.fly(mission, vehicle, parameters=parameters, alter=alteration)
    return ending, FlyNumbers(prepared)([0])[0], run


def test_a_row_is_the_outcome_of_the_run(judged: tuple[str, Row, Run]) -> None:
    """Protects: no campaign calls docked, held or a collision what a run of the same flight calls else."""
    ending, row, run = judged
    assert row["outcome"] == run.outcome.ending == ending
    assert (row["reason"], row["why"]) == (run.outcome.reason, run.outcome.why)


def test_a_row_holds_the_figures_of_the_run(judged: tuple[str, Row, Run]) -> None:
    """Protects: tracking, steps, cost and errors at the end are the run's own, to the bit."""
    _, row, run = judged
    said = figures(run.metrics, run.outcome)
    np.testing.assert_array_equal([row[name] for name in NUMBERS], [said[name] for name in NUMBERS])
    assert run.outcome.true_errors is not None
    assert row["end_range_m"] == run.outcome.true_errors.position_m
    assert row["duration_s"] == run.metrics.duration_s
    assert row["energy_j"] == run.metrics.shaft_energy_j
    last = run.metrics.modes[-1]
    key = {1: "forward", 2: "reverse", 3: "hover"}[last.mode]
    assert row[f"{key}_depth_m_rms"] == last.depth_error_rms_m
    assert row[f"{key}_heading_deg_worst"] == last.heading_error_max_deg


def test_a_row_is_what_the_log_says(judged: tuple[str, Row, Run], tmp_path: Path) -> None:
    """Protects: whoever opens the log of a campaign's flight finds the campaign's outcome and figures."""
    _, row, run = judged
    stored = bumpless.open_run(run.save(tmp_path / "f.mcap"))
    assert (stored.outcome.ending, stored.outcome.reason) == (row["outcome"], row["reason"])
    assert stored.metrics.d_u_fr_settling == pytest.approx(row["late_step_fr"], nan_ok=True, abs=0.0)


def test_the_campaigns_own_limits_count(tmp_path: Path) -> None:
    """Protects: `docked` of a campaign says what docked means in it: position, heading, speed and time."""
    whole = campaign_of("docking", {}, tmp_path)
    for said in ("range_m: 1e-6", "heading_deg: 1e-6", "speed_mps: 1e-9", "hold_s: 80"):
        strict = parse_campaign(HEAD.format(mission="m.yaml") + f"docked: {{{said}}}\n", folder=tmp_path)
        assert FlyNumbers(strict)([0])[0]["outcome"] == "held"
    assert FlyNumbers(whole)([0])[0]["outcome"] == "docked"


def test_what_did_not_happen_is_nan(judged: tuple[str, Row, Run]) -> None:
    """Protects: a figure of a mode that was not flown is no zero, which would be the best there is."""
    _, _, run = judged
    nothing = figures(Metrics(d_u_fr=np.nan), run.outcome)
    assert np.isnan(nothing["hover_depth_m_rms"]) and np.isnan(nothing["largest_step"])
