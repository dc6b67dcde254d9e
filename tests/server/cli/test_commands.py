"""The commands as a user types them: output, JSON and exit codes."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest
from typer import Exit
from typer.testing import CliRunner

from bumpless import open_run
from bumpless.config.whole import NotWritten
from bumpless.contract.exits import MISUSED, NOT_AS_REQUIRED, REFUSED
from bumpless.metrics import as_dict
from bumpless.runs.summary import summarise
from bumpless_server.cli.campaign import said_plainly
from bumpless_server.cli.main import app

MISSIONS = Path(__file__).parents[3] / "missions"
DOCKING = MISSIONS / "docking.yaml"


@pytest.fixture
def short(tmp_path: Path) -> Path:
    """The docking mission, cut to three seconds."""
    path = tmp_path / "short.yaml"
    text = DOCKING.read_text(encoding="utf-8")
    path.write_text(text.replace("duration_s: 90", "duration_s: 3"), encoding="utf-8")
    return path


def bumpless(*arguments: object, code: int = 0) -> tuple[str, str]:
    """Standard output and standard error of a command that ends with `code`."""
    result = CliRunner().invoke(app, [str(a) for a in arguments])
    assert result.exit_code == code, result.output
    return result.stdout, result.stderr


def test_help_imports_nothing_heavy() -> None:
    """`bumpless --help` answers at once: no compiler, no numbers, no web, no bus."""
    heavy = ("numba", "numpy", "scipy", "viser", "zenoh", "fastapi", "pydantic", "google.protobuf", "mcap")
    code = (
        "import sys\n"
        "from bumpless_server.cli.main import app\n"
        "try:\n    app(['--help'])\n"
        "except SystemExit:\n    pass\n"
        f"print([name for name in {heavy!r} if name in sys.modules])\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "validate" in done.stdout
    assert done.stdout.splitlines()[-1] == "[]"


def test_every_command_explains_itself() -> None:
    """Each command has a help text with its options."""
    for command in ("serve", "vehicle", "run", "validate", "metrics", "envelope", "repair"):
        assert "--help" in bumpless(command, "--help")[0]


def test_run_prints_json_and_writes_a_log(short: Path, tmp_path: Path) -> None:
    """One JSON document on standard output; the file holds the same metrics and what made them."""
    out = tmp_path / "short.mcap"
    result = json.loads(bumpless("run", short, "--out", out, "--json", "--seed", "5")[0])
    assert (result["mission"], result["vehicle"], result["seed"]) == ("docking", "ts100", 5)
    assert result["simulated_s"] == pytest.approx(3.0)
    assert result["metrics"]["cycles"] == 60
    assert result["metrics"]["increment_violations"] == 0
    assert as_dict(open_run(out).metrics) == result["metrics"]
    assert result["outcome"]["ending"] == "time_over"
    summary = summarise(out)
    assert (summary.run_id, summary.state) == (result["run_id"], "complete")
    assert summary.metrics == result["metrics"]
    assert not list(tmp_path.glob("*.part"))


def test_a_run_says_what_stands_against_its_mission() -> None:
    """Protects: a mission that the check refuses was flown without a word, and its exit code was 0."""
    told, said = bumpless("run", MISSIONS / "docking_refused.yaml")
    assert "error: target.heading_deg: ts100 can't hold" in said and "Waved off" in told
    assert bumpless("run", MISSIONS / "docking.yaml")[1].count("error:") == 0


def test_a_required_outcome_is_the_exit_code(short: Path, tmp_path: Path) -> None:
    """Protects: a script that flies learns from the code whether it docked; the log is written anyway."""
    out = tmp_path / "short.mcap"
    said, error = bumpless("run", short, "--out", out, "--require", "docked, held", code=NOT_AS_REQUIRED)
    assert said.splitlines()[1].startswith("Time over: the time was over before hover, truly ")
    assert "required: docked or held; the run ended time over" in error
    assert summarise(out).outcome == "time_over" and "before hover" in summarise(out).outcome_reason
    bumpless("run", short, "--require", "time_over")
    _, error = bumpless("run", short, "--require", "landed", code=2)
    assert "docked, held, waved_off, time_over, aborted, collided, interrupted" in "".join(error.split("\n"))
    assert bumpless("metrics", out)[0].startswith("Time over: ")


def test_the_same_seed_flies_the_same_flight(short: Path) -> None:
    """Everything but the clock is equal; another seed differs."""
    runs = [json.loads(bumpless("run", short, "--json", "--seed", seed)[0])["metrics"] for seed in (1, 1, 2)]
    residuals = [run["residual_rms"] for run in runs]
    assert residuals[0] == residuals[1] != residuals[2]


def test_set_changes_parameters(short: Path) -> None:
    """`--set` takes JSON values and changes what is flown; the hash says so."""
    plain = json.loads(bumpless("run", short, "--json")[0])
    changed = json.loads(
        bumpless("run", short, "--json", "--set", "forward.lambda=0.1", "--set", "bumpless.ramp=false")[0]
    )
    assert plain["parameters_sha256"] != changed["parameters_sha256"]
    assert plain["metrics"]["residual_rms"] != changed["metrics"]["residual_rms"]


def test_text_output_shows_speed_and_figures(short: Path) -> None:
    """People read a table."""
    out, _ = bumpless("run", short)
    assert "times real time" in out
    assert "RMS e_tau" in out


@pytest.mark.parametrize(
    ("arguments", "code", "said"),
    [
        (["--set", "hover.lambda=-1"], 1, "--set: hover.lambda = -1; must be between"),
        (["--set", "hover.lamda=1"], 1, "--set: hover.lamda"),
        (["--set", "hover"], 2, "must be section.key=value"),
        (["--vehicle", "nothing"], 1, "no such vehicle"),
        (["--seed", "-1"], 2, "seed"),
        (["--out", "/nonexistent/x.mcap"], 1, "No such file or directory"),
    ],
)
def test_run_refuses_plainly(short: Path, arguments: list[str], code: int, said: str) -> None:
    """Reason on standard error, nothing on standard output, an exit code that scripts can use."""
    out, error = bumpless("run", short, *arguments, code=code)
    assert said in error
    assert out == ""


def test_validate_accepts_what_is_shipped() -> None:
    """All missions in missions/ pass, but the one that says in its title that it does not dock."""
    files = sorted(MISSIONS.glob("*.yaml"))
    refused = [path for path in files if "(does not dock)" in path.read_text(encoding="utf-8")]
    assert [path.stem for path in refused] == ["docking_refused"]
    out, _ = bumpless("validate", *(path for path in files if path not in refused))
    assert out.count(": ok") == len(files) - 1
    out, error = bumpless("validate", *refused, code=1)
    assert "ts100 can't hold heading 000°" in out + error


def test_validate_names_every_fault(short: Path) -> None:
    """file:line:column: field = value; rule, and exit code 1; the same as JSON."""
    text = short.read_text(encoding="utf-8").replace("duration_s: 3", "duration_s: fast")
    short.write_text(text, encoding="utf-8")
    line = 1 + text.splitlines().index("duration_s: fast")
    _, error = bumpless("validate", short, code=1)
    assert error.startswith(f"{short}:{line}:1: duration_s = fast; must be a number in s")
    (result,) = json.loads(bumpless("validate", "--json", short, code=1)[0])
    assert result["ok"] is False
    assert result["problems"][0]["field"] == "duration_s"


def test_validate_wants_text(tmp_path: Path) -> None:
    """Binary data is a plain refusal."""
    path = tmp_path / "binary.yaml"
    path.write_bytes(b"\xff\xfe\x00")
    assert "not UTF-8" in bumpless("validate", path, code=1)[1]
    assert bumpless("validate", code=2)[1]


def test_validate_answers_for_every_file(tmp_path: Path) -> None:
    """Protects: one file that can't be read, or is none of ours, takes no answer from the others."""
    latin = tmp_path / "latin.yaml"
    latin.write_bytes("version: 1\n# 45°\n".encode("latin-1"))
    plan = tmp_path / "sub.plan"
    plan.write_text('{"fileType": "Plan", "mission": {"items": []}, "version": 1}')
    out, _ = bumpless("validate", "--json", latin, tmp_path / "none.yaml", tmp_path, plan, DOCKING, code=1)
    results = json.loads(out)
    assert [result["ok"] for result in results] == [False, False, False, False, True]
    first, absent, folder, foreign = (result["problems"][0] for result in results[:4])
    assert (first["line"], first["column"]) == (2, 5)
    assert "byte 0xb0 at offset 15" in first["rule"]
    assert absent["rule"].startswith("cannot be read: No such file")
    assert folder["rule"].startswith("cannot be read: Is a directory")
    assert foreign["rule"] == "is a QGroundControl plan, not a Bumpless mission"


def test_envelope_prints_both_sets() -> None:
    """At rest fins do nothing; at speed they widen both sets."""
    rest = json.loads(bumpless("envelope", "--speed", "0", "--json")[0])
    fast = json.loads(bumpless("envelope", "--speed", "0.7", "--json")[0])
    assert rest["force"]["extent"]["Y"] == pytest.approx([0.0, 0.0], abs=1e-12)
    assert fast["moment"]["volume"] > 100 * rest["moment"]["volume"] >= 0.0
    assert "N·m" in bumpless("envelope")[0]
    assert "no such vehicle" in bumpless("envelope", "--vehicle", "nothing", code=1)[1]


def test_metrics_and_repair_of_a_cut_log(short: Path, tmp_path: Path) -> None:
    """Metrics need no whole file; repair makes it whole and says how much there was."""
    out = tmp_path / "short.mcap"
    bumpless("run", short, "--out", out)
    whole = json.loads(bumpless("metrics", out, "--json")[0])
    data = out.read_bytes()
    out.write_bytes(data[:-100])
    assert json.loads(bumpless("metrics", out, "--json")[0]) == whole
    assert "repaired" in bumpless("repair", out)[0]
    assert bumpless("repair", out)[0].endswith("whole\n")
    assert json.loads(bumpless("metrics", out, "--json")[0]) == whole
    out.write_bytes(b"no log")
    assert "not an MCAP file" in bumpless("metrics", out, code=1)[1]
    assert "not an MCAP file" in bumpless("repair", out, code=1)[1]


def test_version_and_no_arguments() -> None:
    """The first things that anyone types."""
    assert bumpless("--version")[0].startswith("bumpless ")
    assert "Usage" in CliRunner().invoke(app, []).output


@pytest.fixture
def log(short: Path, tmp_path: Path) -> Path:
    """A log of three seconds."""
    bumpless("run", short, "--out", tmp_path / "short.mcap")
    return tmp_path / "short.mcap"


def test_what_cannot_be_written_is_one_line_and_costs_nothing(log: Path, short: Path) -> None:
    """Protects: a full or closed disk was a traceback, and took what stood in the file before."""
    device = log.with_name("pipe")
    os.mkfifo(device)
    said = ("is no ordinary file", "No such file or directory")
    for target, why in zip((device, log.with_name("nowhere") / "x"), said, strict=True):
        for words in (
            ("run", short, "--out", target),
            ("report", log, "--out", target),
            ("compare", log, log, "--report", target),
            ("refly", log, "--out", target),
            ("identify", log, "--out", target),
            *(("export", log, "--as", kind, "--out", target) for kind in ("mcap", "csv", "alog", "layout")),
        ):
            done = CliRunner().invoke(app, [str(word) for word in words])
            assert done.exit_code in (REFUSED, MISUSED), (words, done.output)
            assert isinstance(done.exception, SystemExit), (words, done.exception)
            assert f"{target}: {why}" in done.stderr.splitlines()[-1], (words, done.stderr)
    assert device.is_fifo()


def test_a_campaign_on_a_full_disk_says_that_what_is_stored_stays() -> None:
    """Protects: a disk that was full after hours ended in a traceback, without the way on."""
    full = "flights/00000000-00000063.parquet"
    with pytest.raises(Exit) as ended, said_plainly():
        raise NotWritten(28, "No space left on device", full)
    assert ended.value.exit_code == REFUSED
