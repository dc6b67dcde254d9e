"""A flight in pieces is one flight: replayed over its gap, judged by what was recorded, and by no more."""

from pathlib import Path

import numpy as np
import pytest

import bumpless
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.messages import decoded
from bumpless.runs.flight_replay import FlightReplay
from bumpless.runs.open_flight import open_flight
from bumpless.runs.pieces import piece_name, piece_of
from bumpless.runs.repair import repair
from bumpless.runs.replay import NoReplay
from tests.pieces import in_pieces
from tests.runs.flights import Flight

CUT, AGAIN, HELD = 12.0, 19.5, 5.0
CLOCK_NS = 3_600_000_000_000  # the server's clock was set forward by an hour meanwhile


@pytest.fixture(scope="module")
def pieces(flight: Flight, tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Before a crash, after it, and the hold; the first as a restarted server mends it."""
    paths = in_pieces(flight.run, tmp_path_factory.mktemp("pieces"), CUT, AGAIN, HELD, CLOCK_NS)
    repair(paths[0])
    return paths


@pytest.fixture(scope="module")
def replay(pieces: list[Path]) -> FlightReplay:
    return FlightReplay(pieces)


def navigation(frame: pb.StreamFrame) -> pb.Navigation:
    told = next(m for m in frame.messages if m.topic == "tlm/navigation")
    message = decoded(told.schema, told.payload)
    assert isinstance(message, pb.Navigation)
    return message


def received(frame: pb.StreamFrame) -> int:
    """When the server had the cycle's navigation, ns."""
    return next(m.receive_time_ns for m in frame.messages if m.topic == "tlm/navigation")


@pytest.mark.parametrize(
    ("name", "piece"),
    [
        ("a", 1),
        ("a.2", 2),
        ("a.10", 10),
        ("a.1", 0),
        ("a.02", 0),
        ("a.x", 0),
        ("a-copy2", 0),
        ("b", 0),
        ("a.", 0),
    ],
)
def test_a_piece_is_known_by_its_name_alone(name: str, piece: int) -> None:
    """Protects copies and strangers' files from being taken for a part of a flight."""
    assert piece_of(name, "a") == piece
    assert piece_of("", "") <= 1 and piece_of(".2", "") == 0


def test_the_recorders_names_are_known_as_pieces() -> None:
    """Protects long names: the number keeps its place behind them."""
    for flight in ("a", "a" * 127):
        assert [piece_of(piece_name(flight, k), flight) for k in (1, 2, 3, 11)] == [1, 2, 3, 11]


def test_a_replay_leads_over_the_gap_on_one_axis(replay: FlightReplay, flight: Flight) -> None:
    """Protects times: a server's clock that was set, or a piece that begins late, moves no cycle."""
    end = float(flight.run.columns.time[-1])
    assert replay.first_s == 0.0 and replay.last_s == pytest.approx(end + HELD, abs=0.11)
    assert [piece.id for piece in replay.pieces] == [piece_name(flight.run.info.run_id, k) for k in (1, 2, 3)]
    ((first, last),) = replay.gaps
    assert (first, last) == (pytest.approx(CUT, abs=0.051), pytest.approx(AGAIN, abs=0.051))
    frames = list(replay.frames(0.0, replay.last_s, 10_000))
    times = np.array([navigation(frame).stamp.mission_time_s for frame in frames])
    told = np.array([received(frame) for frame in frames]) * 1e-9
    assert (np.diff(times) > 0).all() and np.ptp(told - times) < 0.01


def test_in_a_gap_the_last_word_before_it_stands_with_its_age(replay: FlightReplay) -> None:
    """Protects from a value that nobody told: what is shown in a gap is old, and says so."""
    frame = replay.at(CUT + 4.0)
    assert navigation(frame).stamp.mission_time_s == pytest.approx(CUT, abs=0.051)
    assert (frame.server_time_ns - received(frame)) * 1e-9 == pytest.approx(4.0, abs=0.06)
    assert list(replay.frames(CUT + 0.1, AGAIN - 0.1, 100)) == []
    assert navigation(replay.at(AGAIN + 1.0)).stamp.mission_time_s == pytest.approx(AGAIN + 1.0, abs=0.051)


def test_figures_are_of_what_was_recorded_and_say_how_much_is_missing(
    pieces: list[Path], flight: Flight
) -> None:
    """Protects from figures of cycles that nobody saw: no step over the gap, no switch that fell into it."""
    joined, whole = open_flight(pieces), flight.run
    cycles = round((AGAIN - CUT) / 0.05)
    assert joined.metrics.missing_cycles == pytest.approx(cycles, abs=1)
    assert joined.metrics.cycles + joined.metrics.missing_cycles == whole.metrics.cycles
    assert joined.outcome.ending == whole.outcome.ending and joined.outcome.sentence == whole.outcome.sentence
    assert joined.metrics.d_u_rh == whole.metrics.d_u_rh
    assert joined.metrics.increment_violations == joined.metrics.demand_step_violations == 0
    ((first, last),) = joined.columns.gaps
    assert (first, last) == (pytest.approx(CUT, abs=0.051), pytest.approx(AGAIN, abs=0.051))
    told = [topic for topic, _ in joined.messages() if topic == "tlm/control"]
    assert len(told) == joined.metrics.cycles + HELD


def test_a_switch_in_the_gap_has_no_step(flight: Flight, tmp_path: Path) -> None:
    """Protects d_u: the largest step about a switch that nobody saw is not known, and not small."""
    switch = flight.run.metrics.switches[0]
    joined = open_flight(in_pieces(flight.run, tmp_path, switch.time_s - 1.0, switch.time_s + 3.0))
    first = joined.metrics.switches[0]
    assert (first.from_mode, first.to_mode) == (switch.from_mode, switch.to_mode)
    assert first.time_s == pytest.approx(switch.time_s + 3.0, abs=0.051)
    assert np.isnan([first.command_step_normalised, first.command_step_settling, joined.metrics.d_u_fr]).all()
    assert joined.metrics.d_u_rh == flight.run.metrics.d_u_rh


def test_a_flight_without_its_end_is_interrupted(pieces: list[Path]) -> None:
    """Protects the verdict: the end is the last flown piece's, whatever a hold or a first piece says."""
    assert (
        open_flight(pieces[:1]).outcome.ending == bumpless.open_run(pieces[0]).outcome.ending == "interrupted"
    )
    assert open_flight(pieces[1:]).outcome.ending == open_flight(pieces).outcome.ending != "interrupted"


def test_a_copy_beside_a_flight_tells_nothing_twice(pieces: list[Path], tmp_path: Path) -> None:
    """Protects from a file that says it is a piece and holds what another one holds."""
    copy = tmp_path / pieces[1].name.replace(".2", ".4")
    copy.write_bytes(pieces[1].read_bytes())
    assert len(FlightReplay([*pieces, copy]).pieces) == 3
    assert open_flight([*pieces, copy]).metrics.cycles == open_flight(pieces).metrics.cycles


def test_what_cannot_be_replayed_costs_the_others_nothing(pieces: list[Path], tmp_path: Path) -> None:
    """Protects the rest of a flight from one damaged file."""
    junk = tmp_path / "junk.mcap"
    junk.write_bytes(b"\x89MCAP0\r\n" + b"\xff" * 100)
    assert len(FlightReplay([junk, *pieces[1:]]).pieces) == 2
    with pytest.raises(NoReplay):
        FlightReplay([junk])
