"""From LOG rows to messages: units at the edge, one order, and the same row gives the same bytes."""

import math
from typing import Any

import numpy as np
import pytest

from bumpless.config.mission import parse_mission
from bumpless.config.parameters import Parameters, default_parameters
from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.keys import TOPICS, Topic
from bumpless.sim.log import LOG
from bumpless.telemetry import FlightState, Teller, make_context, messages
from tests.node.flying import MISSIONS, START_NS, Flying

PER_CYCLE = [f"tlm/{name}" for name, topic in TOPICS.items() if topic.rate_hz is None]


@pytest.fixture(scope="module")
def vehicle() -> Vehicle:
    return load_vehicle("ts100")


@pytest.fixture(scope="module")
def parameters(vehicle: Vehicle) -> Parameters:
    return default_parameters(vehicle)


def random_row(seed: int) -> np.void:
    """A row with a different number in every place; integers small, a mission running."""
    rng = np.random.default_rng(seed)
    made = np.zeros(1, LOG)
    for name in LOG.names or ():
        integer = LOG[name].base.kind == "i"
        made[name] = rng.integers(0, 3, made[name].shape) if integer else rng.normal(size=made[name].shape)
    made["phase"] = pb.MISSION_PHASE_RUNNING
    return made[0]


def test_every_field_is_in_the_units_of_the_contract(vehicle: Vehicle, parameters: Parameters) -> None:
    """Degrees, rpm, SI: each number of the row at its place in its message."""
    row = random_row(1)
    told: dict[str, Any] = dict(messages(row, make_context(vehicle, parameters), time_ns=START_NS))
    nav, guide, control = told["tlm/navigation"], told["tlm/guidance"], told["tlm/control"]
    target, truth, actuators = told["tlm/target"], told["truth/state"], told["tlm/actuators"]
    assert nav.stamp == pb.Stamp(time_ns=START_NS, mission_time_s=row["time"], cycle=int(row["cycle"]))
    assert [nav.position_ned_m.x, nav.position_ned_m.y, nav.position_ned_m.z] == row["eta_hat"][:3].tolist()
    assert nav.attitude.yaw_deg == pytest.approx(math.degrees(row["eta_hat"][5]))
    assert nav.angular_rate_body_degps.y == pytest.approx(math.degrees(row["nu_hat"][4]))
    assert nav.speed_over_ground_mps == pytest.approx(np.linalg.norm(row["nu_hat"][:3]))
    assert guide.depth_reference_m == row["reference"][2]
    assert guide.attitude_reference.pitch_deg == pytest.approx(math.degrees(row["reference"][4]))
    assert told["tlm/supervisor"].mode == row["mode"]
    assert told["tlm/supervisor"].range_fr_lower_m == parameters.supervisor.range_fr_lower_m
    assert control.residual.k_nm == pytest.approx(row["tau_d"][3] - row["tau_c"][3])
    assert control.demanded_raw.n_nm == row["tau_plus"][5]
    assert target.bearing_deg == pytest.approx(math.degrees(row["target_measured"][1]))
    assert target.heading_deg == pytest.approx(math.degrees(row["target"][3]))
    assert truth.actuator_wrench.z_n == row["tau"][2]
    assert truth.target_position_ned_m.y == row["target_true"][1]
    assert target.position_ned_m.y == row["target"][1]
    assert list(truth.effectiveness) == row["effectiveness"][: len(vehicle.commands)].tolist()
    assert told["tlm/allocation"].solve_time_us == pytest.approx(row["solve_time"] * 1e6)
    per_si = {"deg": 180.0 / math.pi, "rpm": 60.0}
    for i, (said, command) in enumerate(zip(actuators.actuators, vehicle.commands, strict=True)):
        assert (said.name, said.unit) == (command.name, command.unit)
        assert said.command == pytest.approx(row["u"][i] * per_si[command.unit])
        assert said.effectiveness == row["effectiveness_hat"][i]
        assert said.fault_evidence == row["fault_evidence"][i]
        assert said.faulty == bool(int(row["faults"]) >> i & 1)
        assert said.increment_bound == pytest.approx(row["du_max"][i] * per_si[command.unit])
        assert (said.amplitude_lower, said.amplitude_upper) == (command.lower, command.upper)


def test_bounds_show_which_limit_holds_an_actuator(vehicle: Vehicle, parameters: Parameters) -> None:
    """At an amplitude bound it is saturated, at an increment bound rate limited, between them neither."""
    made = np.zeros(1, LOG)
    row = made[0]
    limit = [c.upper * (math.pi / 180 if c.unit == "deg" else 1 / 60) for c in vehicle.commands]
    row["u_lower"][: len(limit)] = [-0.5 * x for x in limit]
    row["u_upper"][: len(limit)] = [limit[0], *(0.5 * x for x in limit[1:])]
    row["u"][:3] = limit[0], 0.5 * limit[1], 0.1 * limit[2]
    told: dict[str, Any] = dict(messages(row, make_context(vehicle, parameters)))
    first, second, third = told["tlm/actuators"].actuators[:3]
    assert (first.saturated, first.rate_limited) == (True, False)
    assert (second.saturated, second.rate_limited) == (False, True)
    assert (third.saturated, third.rate_limited) == (False, False)
    assert told["tlm/allocation"].saturated_count == 1


def test_the_same_row_gives_the_same_bytes(vehicle: Vehicle, parameters: Parameters) -> None:
    """Node and log go through one path; nothing in it may depend on anything but its arguments."""
    for seed in range(20):
        first, second = (
            [
                (topic, message.SerializeToString(deterministic=True))
                for topic, message in messages(random_row(seed), make_context(vehicle, parameters, START_NS))
            ]
            for _ in range(2)
        )
        assert first == second
        assert [topic for topic, _ in first if topic.startswith("tlm/")] == sorted(
            PER_CYCLE, key=[topic for topic, _ in first].index
        )


def test_every_topic_is_told_at_its_rate(vehicle: Vehicle, parameters: Parameters) -> None:
    """Four idle seconds: the per-cycle topics each time, the slow ones at the rate of the contract."""
    teller, state = (
        Teller(vehicle, parameters, health=lambda stamp: pb.Health(stamp=stamp)),
        FlightState(parameters),
    )
    made = np.zeros(1, LOG)
    made["phase"], made["time"] = pb.MISSION_PHASE_IDLE, 4.0
    counts: dict[str, int] = {}
    for n in range(80):
        said: list[tuple[str, Any]] = list(teller.tell(made[0], state, (), START_NS + n * 50_000_000, n))
        for topic, message in said:
            counts[topic] = counts.get(topic, 0) + 1
            assert (message.stamp.cycle, message.stamp.mission_time_s) == (n, 0.0)  # no mission, no time
    assert {topic: counts[topic] for topic in PER_CYCLE} == dict.fromkeys(PER_CYCLE, 80)
    slow = {"tlm/mission": 8, "tlm/parameters": 4, "tlm/health": 4, "tlm/description": 2}
    assert {topic: counts[topic] for topic in slow} == slow
    assert "tlm/plan" not in counts


def test_a_rate_makes_a_topic_of_rows_rarer(
    vehicle: Vehicle, parameters: Parameters, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Protects: a topic told of rows needs its rate in the table of topics and nothing else."""
    monkeypatch.setitem(TOPICS, "target", Topic("target", pb.Target, rate_hz=4.0))
    teller, state = Teller(vehicle, parameters), FlightState(parameters, 1)
    row = random_row(3)
    told = [topic for _ in range(10) for topic, _ in teller.tell(row, state)]
    assert told.count("tlm/target") == 2 and told.count("tlm/control") == 10


def test_a_run_is_announced_before_its_first_row_and_ended_after_its_last() -> None:
    """Whoever records from RUNNING to the end of a run has all of it, with plan and parameters."""
    flying = Flying()
    assert flying.start().accepted
    flying.clock.fly(30)
    assert flying.ask("abort").accepted
    teller = Teller(flying.vehicle, flying.flight.chosen)
    told: list[tuple[str, Any]] = []
    for cycle in flying.end():
        told += teller.tell(cycle.row, cycle.state, cycle.events, cycle.time_ns, cycle.number)
    phases = [(i, m) for i, (topic, m) in enumerate(told) if topic == "tlm/mission"]
    running = next(i for i, m in phases if m.phase == pb.MISSION_PHASE_RUNNING)
    over, last = next((i, m) for i, m in phases if m.phase == pb.MISSION_PHASE_ABORTED)
    assert last.end_reason == "Mission aborted: aborted by the operator."
    flown = [
        i for i, (topic, m) in enumerate(told) if topic == "tlm/navigation" and m.stamp.mission_time_s > 0
    ]
    assert running < flown[0]
    assert "tlm/plan" in {topic for topic, _ in told[: flown[0]]}
    first_aborted = next(
        i for i, (topic, m) in enumerate(told) if topic == "event" and m.code == "mission_aborted"
    )
    assert first_aborted < over


def test_the_elapsed_time_of_a_run_stops_with_it() -> None:
    """A run that is over does not grow older on the operator's screen."""
    flying = Flying()
    assert flying.start().accepted
    flying.clock.fly(30)
    assert flying.ask("abort").accepted
    flying.clock.fly(40)
    teller = Teller(flying.vehicle, flying.flight.chosen)
    told: list[tuple[str, Any]] = []
    for cycle in flying.end():
        told += teller.tell(cycle.row, cycle.state, cycle.events, cycle.time_ns, cycle.number)
    said = [message for topic, message in told if topic == "tlm/mission"]
    over = [message.elapsed_s for message in said if message.phase == pb.MISSION_PHASE_ABORTED]
    assert len(over) > 1 and len(set(over)) == 1 and over[0] > 0


def test_a_pause_moves_the_limit_of_the_elapsed_time(vehicle: Vehicle, parameters: Parameters) -> None:
    """Protects: after a pause the screen showed more elapsed time than the mission could last."""
    mission = parse_mission((MISSIONS / "docking.yaml").read_text(), "docking.yaml", vehicle)
    state = FlightState(parameters, 1, mission, "run-1", 0)
    teller = Teller(vehicle, parameters)
    row = np.zeros(1, LOG)[0]
    said: list[pb.MissionStatus] = []

    def fly(seconds: float, phase: int) -> None:
        for _ in range(round(seconds / vehicle.control_period_s)):
            row["cycle"] += 1
            row["time"] = vehicle.control_period_s * row["cycle"]
            row["phase"] = phase
            said.extend(m for _, m in teller.tell(row, state) if isinstance(m, pb.MissionStatus))

    fly(10.0, pb.MISSION_PHASE_RUNNING)
    assert said[-1].duration_s == mission.duration_s
    for _ in range(2):
        fly(30.0, pb.MISSION_PHASE_PAUSED)
        left = {round(m.duration_s - m.elapsed_s, 6) for m in said if m.phase == pb.MISSION_PHASE_PAUSED}
        assert len(left) == 1  # time stands still
        said.clear()
        fly(10.0, pb.MISSION_PHASE_RUNNING)
    fly(mission.duration_s - 30.0 - vehicle.control_period_s, pb.MISSION_PHASE_RUNNING)
    fly(vehicle.control_period_s, pb.MISSION_PHASE_COMPLETED)
    assert said[-1].duration_s == pytest.approx(mission.duration_s + 60.0)
    assert said[-1].elapsed_s == pytest.approx(said[-1].duration_s)
    state = FlightState(parameters, 1, mission, "run-2", 0)
    row["cycle"] = 0
    fly(1.0, pb.MISSION_PHASE_RUNNING)
    assert said[-1].duration_s == mission.duration_s
