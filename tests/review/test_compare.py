"""Runs beside each other: which is better by what, what they were flown with, and a gate that says no."""

from dataclasses import replace
from pathlib import Path

import pytest
from typer.testing import CliRunner

import bumpless
from bumpless.contract.exits import FLOWN, GATE_FAILED, MISUSED
from bumpless.review.compare import change_of, compare
from bumpless.review.figures import FIGURES, moments
from bumpless.review.gate import GateError, judge, read_gate
from bumpless.review.subject import Subject, subject_of
from bumpless_server.cli.main import app

MISSION = Path(__file__).parents[2] / "missions" / "docking.yaml"


@pytest.fixture(scope="module")
def logs(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """The same mission with another seed and another weight."""
    folder = tmp_path_factory.mktemp("logs")
    runs = bumpless.fly(MISSION), bumpless.fly(MISSION, seed=5, parameters={"hover": {"lambda": 0.5}})
    return [run.save(folder / f"{name}.mcap") for name, run in zip("ab", runs, strict=True)]


@pytest.fixture(scope="module")
def subjects(logs: list[Path]) -> list[Subject]:
    return [subject_of(log) for log in logs]


def test_figures_are_those_of_the_runs(logs: list[Path], subjects: list[Subject]) -> None:
    """Protects the table: what stands in it is what `bumpless metrics` prints."""
    comparison = compare(subjects)
    rows = {row.figure.key: row for row in comparison.figures}
    for index, log in enumerate(logs):
        metrics = bumpless.open_run(log).metrics
        assert rows["d_u_rh"].values[index] == pytest.approx(metrics.d_u_rh)
        hover = next(mode for mode in metrics.modes if mode.mode == 3)
        assert rows["hover.depth_error_rms_m"].values[index] == pytest.approx(hover.depth_error_rms_m)
        assert rows["end.position_m"].values[index] == pytest.approx(metrics.outcome.true_errors.position_m)


def test_what_differs_is_named_and_nothing_else(subjects: list[Subject]) -> None:
    """Protects the answer to "why are they different": the weight and the seed that were changed."""
    rows = {(row.kind, row.name): row.values for row in compare(subjects).settings}
    assert rows[("parameters", "hover.lambda")][1] == "0.5"
    assert rows[("software", "seed")][1] == "5"
    assert {kind for kind, _ in rows} == {"parameters", "software"}


def test_better_and_worse_go_by_the_figure_and_by_what_is_shown() -> None:
    """Protects from green where more is worse, and from a difference that nobody can see."""
    less, more = FIGURES["d_u_rh"], FIGURES["solved_ratio"]
    assert change_of(less, 0.05, 0.04) == "better" and change_of(more, 0.9, 0.8) == "worse"
    assert change_of(less, 0.05, 0.05001) == "same"
    assert change_of(FIGURES["duration_s"], 80.0, 90.0) == ""
    assert change_of(less, None, 0.1) == ""


def test_runs_can_be_laid_over_each_other_at_their_switches(subjects: list[Subject]) -> None:
    """Protects alignment: the first entry into each mode."""
    found = moments(subjects[0].metrics)
    assert found["start"] == 0.0 < found["reverse"] < found["hover"] < found["end"]


def test_a_run_with_itself_is_the_same_throughout(subjects: list[Subject]) -> None:
    """Protects from a difference made by comparing."""
    comparison = compare([subjects[0]] * 3)
    assert comparison.settings == ()
    assert {change for row in comparison.figures for change in row.changes[1:]} <= {"same", ""}
    with pytest.raises(ValueError, match="two to 6"):
        compare([subjects[0]])


def gate_file(folder: Path, text: str) -> Path:
    path = folder / "limits.toml"
    path.write_text(text)
    return path


@pytest.mark.parametrize(
    ("text", "passed"),
    [
        ("[figures.d_u_rh]\nmax = 10.0\n", True),
        ("[figures.d_u_rh]\nmax = 1e-6\n", False),
        ("[figures.solved_ratio]\nmin = 0.5\n", True),
        ("[figures.d_u_rh]\nworse_by_percent = 1e6\n", True),
        ('outcome = ["collided"]\n', False),
        ('outcome = ["docked", "held", "time_over", "waved_off"]\n', True),
    ],
)
def test_a_gate_judges_every_run_but_the_first(
    tmp_path: Path, subjects: list[Subject], text: str, passed: bool
) -> None:
    """Protects a build from a change that makes docking worse."""
    (verdict,) = judge(read_gate(gate_file(tmp_path, text)), compare(subjects))
    assert verdict.passed is passed and verdict.run == subjects[1].info.id


def test_what_cannot_be_judged_does_not_pass(tmp_path: Path, subjects: list[Subject]) -> None:
    """Protects: a run that never hovered has no step into hover, which is no small step."""
    without = replace(subjects[1], metrics={**subjects[1].metrics, "d_u_rh": None})
    gate = read_gate(gate_file(tmp_path, "[figures.d_u_rh]\nmax = 10.0\nworse_by = 1.0\n"))
    assert [verdict.passed for verdict in judge(gate, compare([subjects[0], without]))] == [False, False]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("[figures.d_u]\nmax = 1\n", "there is no figure 'd_u'"),
        ("[figures.d_u_rh]\nmost = 1\n", "figures.d_u_rh.most"),
        ("[figures.duration_s]\nworse_by = 1\n", "neither more nor less"),
        ("figures =", "limits.toml"),
    ],
)
def test_a_gate_that_cannot_be_understood_is_refused(tmp_path: Path, text: str, words: str) -> None:
    """Protects from a gate that lets everything through because of a typing error."""
    with pytest.raises(GateError, match=words):
        read_gate(gate_file(tmp_path, text))


def test_the_command_ends_with_a_code_for_a_build(tmp_path: Path, logs: list[Path]) -> None:
    """Protects CI: 0 kept, 4 broken, 2 not understood; the text names figure and limit."""
    runner = CliRunner()
    names = [str(log) for log in logs]
    assert runner.invoke(app, ["compare", *names]).exit_code == FLOWN
    kept = gate_file(tmp_path, "[figures.d_u_rh]\nmax = 10.0\n")
    assert runner.invoke(app, ["compare", *names, "--gate", str(kept)]).exit_code == FLOWN
    broken = gate_file(tmp_path, "[figures.d_u_rh]\nmax = 1e-6\n")
    result = runner.invoke(app, ["compare", *names, "--gate", str(broken)])
    assert result.exit_code == GATE_FAILED and "BROKEN" in result.output and "d_u_rh" in result.output
    assert runner.invoke(app, ["compare", names[0]]).exit_code == MISUSED
    wrong = gate_file(tmp_path, "[figures.x]\nmax = 1\n")
    assert runner.invoke(app, ["compare", *names, "--gate", str(wrong)]).exit_code == MISUSED


def test_a_flight_with_a_gap_is_no_better_for_what_nobody_saw(logs: list[Path]) -> None:
    """Protects from a sum that is small because half of it is missing; how it ended is still compared."""
    whole, other = (subject_of(log) for log in logs[:2])
    metrics = {**other.metrics, "missing_cycles": 400, "shaft_energy_j": 0.1}
    rows = {row.figure.key: row for row in compare([whole, replace(other, metrics=metrics)]).figures}
    assert rows["shaft_energy_j"].values[1] == 0.1 and rows["shaft_energy_j"].changes == ("", "")
    assert rows["missing_cycles"].changes[1] == "worse" and rows["end.position_m"].changes[1] != ""
