"""The public face: what `import bumpless` offers, and that runs are the same from memory as from a file."""

import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import bumpless
from bumpless.contract.messages import encoded
from bumpless.runs.repair import repair
from bumpless.runs.table import Table, table_of
from tests.runs.flights import START_NS, Flight

DOCKING = Path(__file__).parents[2] / "missions" / "docking.yaml"


@pytest.fixture(scope="module")
def opened(flight: Flight, tmp_path_factory: pytest.TempPathFactory) -> bumpless.Run:
    """The flight, saved and opened again."""
    return bumpless.open_run(flight.run.save(tmp_path_factory.mktemp("face") / "run.mcap"))


def same(one: Table, other: Table) -> None:
    """Equal columns in equal order, to the bit."""
    assert list(one) == list(other)
    for name, column in one.items():
        np.testing.assert_array_equal(column, other[name], err_msg=name)


def test_importing_it_loads_nothing() -> None:
    """Protects: a command that only asks for help must not wait for a compiler."""
    code = (
        "import sys, bumpless; print([m for m in ('numpy', 'numba', 'google', 'mcap') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_every_name_is_there_and_documented() -> None:
    """Protects: the list of names, where they are looked for and what a type checker sees agree."""
    for name in bumpless.__all__:
        assert name == "__version__" or getattr(bumpless, name).__doc__
    assert set(bumpless._HOMES) | {"__version__"} == set(bumpless.__all__) <= set(dir(bumpless))
    with pytest.raises(AttributeError, match="no attribute 'nothing'"):
        bumpless.nothing  # noqa: B018


def test_a_run_is_the_same_from_its_file(flight: Flight, opened: bumpless.Run) -> None:
    """Protects: identity, inputs, figures, outcome and table of a run, to the bit."""
    run = flight.run
    assert opened.info == run.info
    assert (opened.mission, opened.vehicle, opened.parameters) == (run.mission, run.vehicle, run.parameters)
    assert encoded(opened.metrics) == encoded(run.metrics)
    assert opened.outcome == run.outcome
    same(opened.table(), run.table())


def test_columns_carry_their_units_and_the_flights_numbers(flight: Flight) -> None:
    """One row per cycle; degrees and rpm at this edge, as everywhere on the bus."""
    table, log = flight.run.table(), flight.result.log
    assert all(len(column) == len(log) for column in table.values())
    np.testing.assert_array_equal(table["time_s"], log["time"])
    np.testing.assert_allclose(table["actuators.delta_1.command_deg"], np.degrees(log["u"][:, 0]))
    np.testing.assert_allclose(table["truth.position_ned_m.z"], log["eta"][:, 2])
    assert set(table["supervisor.mode"]) == {"FORWARD", "REVERSE", "HOVER"}
    frame, arrow = flight.run.to_pandas(), flight.run.to_arrow()
    assert frame.index.name == "time_s" and list(frame.columns) == [n for n in table if n != "time_s"]
    assert arrow.column_names == list(table) and arrow.num_rows == len(log)


def test_a_cycle_without_a_topic_has_a_hole(flight: Flight) -> None:
    """Protects: a lost message must not shift the rows after it."""
    told = list(flight.run.messages())
    lost = next(k for k, (topic, _) in enumerate(told) if topic == "tlm/control")
    table, full = table_of(told[:lost] + told[lost + 1 :]), flight.run.table()
    assert np.isnan(table["control.demanded.x_n"][0])
    np.testing.assert_array_equal(table["control.demanded.x_n"][1:], full["control.demanded.x_n"][1:])
    same(
        {k: v for k, v in table.items() if "control" not in k},
        {k: v for k, v in full.items() if "control" not in k},
    )


def test_runs_pickle_small_and_whole(flight: Flight, opened: bumpless.Run) -> None:
    """Protects: a thousand runs come back from workers; what comes is what was flown, in half the bytes."""
    data = pickle.dumps(flight.run)
    assert len(data) < 0.6 * flight.result.log.nbytes
    back = pickle.loads(data)
    assert back.info == flight.run.info and back.outcome == flight.run.outcome
    same(back.table(), flight.run.table())
    assert len(pickle.dumps(opened)) < 1000
    assert pickle.loads(pickle.dumps(opened)).outcome == flight.run.outcome


def test_what_flies_pickles() -> None:
    """Missions, vehicles and parameters go to workers."""
    mission, vehicle = bumpless.load_mission(DOCKING), bumpless.load_vehicle("ts100")
    assert pickle.loads(pickle.dumps((mission, vehicle))) == (mission, vehicle)


def test_missions_come_by_name_and_by_path(tmp_path: Path) -> None:
    """A shipped one needs no path; the file's own name stays with the mission."""
    assert bumpless.load_mission("docking") == bumpless.load_mission(DOCKING)
    assert bumpless.load_mission(str(DOCKING)).source == "docking.yaml"
    with pytest.raises(FileNotFoundError):
        bumpless.load_mission("nothing")
    bad = tmp_path / "bad.yaml"
    bad.write_bytes(b"\xff")
    with pytest.raises(bumpless.MissionError, match="not UTF-8"):
        bumpless.load_mission(bad)


@pytest.fixture(scope="module")
def short(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The docking mission, cut to three seconds."""
    path = tmp_path_factory.mktemp("short") / "short.yaml"
    path.write_text(DOCKING.read_text(encoding="utf-8").replace("duration_s: 90", "duration_s: 3"))
    return path


def test_seed_and_parameters_decide_the_flight(short: Path) -> None:
    """The same arguments give the same run, id included; others another."""
    one, same_again = (bumpless.fly(short, seed=7, started_ns=START_NS) for _ in range(2))
    assert one.info == same_again.info
    assert one.metrics.residual_rms == same_again.metrics.residual_rms
    changed = bumpless.fly(short, seed=7, started_ns=START_NS, parameters={"hover": {"lambda": 0.02}})
    assert changed.parameters is not None and changed.parameters.hover.lambda_ == 0.02
    assert changed.info.parameters_sha256 != one.info.parameters_sha256 and changed.info.id != one.info.id
    whole = bumpless.fly(short, seed=7, started_ns=START_NS, parameters=changed.parameters)
    assert whole.info == changed.info


def test_what_cannot_be_flown_is_refused_with_every_problem(short: Path) -> None:
    """Protects: a number out of range never reaches the simulation."""
    with pytest.raises(bumpless.ParameterError, match=r"hover\.lambda = -1; must be between"):
        bumpless.fly(short, parameters={"hover": {"lambda": -1}})
    with pytest.raises(bumpless.ParameterError, match=r"parameters: hover\.lamda"):
        bumpless.fly(short, parameters={"hover": {"lamda": 1}})
    with pytest.raises(bumpless.VehicleError):
        bumpless.fly(short, "nothing")
    with pytest.raises(ValueError, match="not an MCAP file"):
        bumpless.open_run(short)


def test_half_a_file_is_never_left_behind(flight: Flight, tmp_path: Path) -> None:
    """Protects: a stopped save leaves neither a broken log nor a part of one."""

    def stop(share: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        flight.run.save(tmp_path / "run.mcap", progress=stop)
    assert not list(tmp_path.iterdir())
    copy = bumpless.open_run(flight.path).save(tmp_path / "copy.mcap")
    assert copy.read_bytes() == flight.path.read_bytes()


def test_a_cut_log_is_an_interrupted_run(flight: Flight, tmp_path: Path) -> None:
    """Protects: what has no end is never called completed."""
    cut = tmp_path / "cut.mcap"
    data = flight.path.read_bytes()
    cut.write_bytes(data[: len(data) // 2])
    run = bumpless.open_run(cut)
    assert (run.outcome.ending, run.outcome.reason) == ("interrupted", "the recording was cut off")
    assert run.info == flight.run.info


@pytest.mark.parametrize(
    ("data", "why"),
    [
        (b"", "it is empty"),
        (b"\x89MCAP0\r\n", "it ends after 8 bytes, within its header"),
        (b"hello", "it ends after 5 bytes, within its header"),
        (b"version: 1\nname: docking\n", "not a valid MCAP file"),
    ],
)
def test_a_file_that_is_no_log_says_why(tmp_path: Path, data: bytes, why: str) -> None:
    """Protects: a reason after the colon, also where the reader itself has no word."""
    path = tmp_path / "a.mcap"
    path.write_bytes(data)
    with pytest.raises(ValueError, match="not an MCAP file: .*" + why):
        bumpless.open_run(path)
    with pytest.raises(ValueError, match="not an MCAP file: .*" + why):
        repair(path)
