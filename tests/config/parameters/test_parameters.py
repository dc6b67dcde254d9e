"""Parameters: read from the vehicle, overridden by a mission, checked, and carried over the bus."""

from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bumpless.config.parameters import (
    RANGES,
    ParameterError,
    Parameters,
    as_dict,
    check,
    default_parameters,
    from_message,
    live_fields,
    live_problems,
    to_message,
    with_overrides,
)
from bumpless.config.vehicle import Vehicle, load_vehicle, vehicle_names
from bumpless.contract import bumpless_pb2 as pb

TS100 = load_vehicle("ts100")


@pytest.fixture(scope="module")
def ts100() -> Vehicle:
    return TS100


@pytest.fixture(scope="module")
def defaults(ts100: Vehicle) -> Parameters:
    return default_parameters(ts100)


def flyable() -> list[str]:
    return [name for name in vehicle_names() if load_vehicle(name).control]


@pytest.mark.parametrize("name", flyable())
def test_shipped_vehicles_come_with_fit_parameters(name: str) -> None:
    """What ships must pass its own range table."""
    vehicle = load_vehicle(name)
    assert check(default_parameters(vehicle), vehicle) == []


def test_the_range_table_covers_every_number(defaults: Parameters) -> None:
    """A number without a range would reach the vehicle unchecked."""
    numbers = {
        f"{section}.{key}"
        for section, table in as_dict(defaults).items()
        for key, value in table.items()
        if not isinstance(value, bool | str)
    }
    assert {r.path for r in RANGES} == numbers
    assert all(r.min < r.max and r.unit and r.label for r in RANGES)


def test_every_bound_is_enforced(defaults: Parameters) -> None:
    """Just outside of each range is refused under the number's own path, NaN too."""
    for r in RANGES:
        section, key = r.path.split(".")
        value = as_dict(defaults)[section][key]
        for bad in (r.min - max(1.0, abs(r.min)), r.max + max(1.0, abs(r.max)), float("nan")):
            if isinstance(value, int) and bad != bad:
                continue
            table = [bad, *value[1:]] if isinstance(value, list) else bad
            if isinstance(value, int):
                table = int(bad)
            with pytest.raises(ParameterError) as caught:
                with_overrides(defaults, {section: {key: table}})
            assert all(p.field.startswith(r.path) for p in caught.value.problems), (r.path, bad)


def test_rows_have_one_number_per_actuator(ts100: Vehicle, defaults: Parameters) -> None:
    """R of another vehicle does not fit."""
    short = replace(defaults, hover=replace(defaults.hover, r_diagonal=(1.0, 1.0)))
    (problem,) = check(short, ts100)
    assert problem.field == "hover.r_diagonal"
    assert "one per command" in problem.rule


@given(st.permutations([0.5, 1.0, 4.0, 6.0, 8.0]))
def test_only_ascending_thresholds_pass(values: list[float]) -> None:
    """d_RH^L < d_RH^U < d_FR^L < d_FR^U < d_HF^U, eq. (53), whatever the mixture."""
    vehicle = TS100
    names = (
        "range_rh_lower_m",
        "range_rh_upper_m",
        "range_fr_lower_m",
        "range_fr_upper_m",
        "range_hf_upper_m",
    )
    table = {"supervisor": dict(zip(names, values, strict=True))}
    problems = check(with_overrides(default_parameters(vehicle), table), vehicle)
    assert (problems == []) == (values == sorted(values))


def test_more_hits_than_frames_can_never_detect(ts100: Vehicle, defaults: Parameters) -> None:
    """M of N needs M <= N."""
    table = {"supervisor": {"detection_hits": 6, "detection_window": 5}}
    (problem,) = check(with_overrides(defaults, table), ts100)
    assert problem.field == "supervisor.detection_hits"


def test_overrides_change_what_they_name_and_nothing_else(defaults: Parameters) -> None:
    """A mission overrides single numbers; the rest stays the vehicle's."""
    changed = with_overrides(defaults, {"hover": {"lambda": 1}, "bumpless": {"ramp": False}})
    assert changed.hover.lambda_ == 1.0
    assert changed.bumpless.ramp is False
    assert with_overrides(changed, as_dict(defaults)) == defaults
    assert changed.forward == defaults.forward


@pytest.mark.parametrize(
    ("table", "field", "rule"),
    [
        ({"hoover": {}}, "hoover", "unknown field; did you mean hover?"),
        ({"hover": 3}, "hover", "must hold named fields"),
        ({"hover": {"q": [1]}}, "hover.q", "unknown field"),
        ({"hover": {"lambda": "a"}}, "hover.lambda", "must be a number"),
        ({"hover": {"lambda": True}}, "hover.lambda", "must be a number"),
        ({"hover": {"ramp_cycles": 2.5}}, "hover.ramp_cycles", "whole number"),
        ({"hover": {"kp": [1, "a"]}}, "hover.kp", "must be a list of 6 numbers"),
        ({"hover": {"kp": [1, 2, "a", 4, 5, 6]}}, "hover.kp[2]", "must be a number"),
        ({"hover": {"kp": "abcdef"}}, "hover.kp", "must be a list of 6 numbers"),
        ({"hover": {"r_diagonal": []}}, "hover.r_diagonal", "must be a list of numbers, one per command"),
        ({"bumpless": {"ramp": 1}}, "bumpless.ramp", "true or false"),
        ({"allocation": {"solver": "magic"}}, "allocation.solver", "must be one of osqp"),
    ],
)
def test_overrides_of_the_wrong_kind(defaults: Parameters, table: dict, field: str, rule: str) -> None:
    """Unknown names and wrong types are refused by their path."""
    with pytest.raises(ParameterError) as caught:
        with_overrides(defaults, table)
    (problem,) = caught.value.problems
    assert problem.field == field
    assert rule in problem.rule


def test_a_vehicle_without_control_tables_says_what_is_missing(ts100: Vehicle) -> None:
    """The autopilot has no gains of its own to fall back on."""
    with pytest.raises(ParameterError) as caught:
        default_parameters(replace(ts100, control={}))
    missing = {problem.field for problem in caught.value.problems}
    assert {"forward.kp", "hover.q_diagonal", "supervisor.dwell_cycles"} <= missing


def test_the_message_carries_every_live_number(defaults: Parameters) -> None:
    """Through the bus and back nothing changes, and what is not live stays the base's."""
    message = to_message(defaults)
    read = pb.Parameters.FromString(message.SerializeToString())
    assert from_message(read, defaults) == defaults
    read.hover.ramp_cycles = 7
    read.supervisor.range_rh_lower_m = 0.3
    changed = from_message(read, defaults)
    assert changed.hover.ramp_cycles == 7
    assert changed.hover.kp == defaults.hover.kp
    assert changed.supervisor.range_rh_lower_m == 0.3
    assert changed.guidance == defaults.guidance


def test_sections_a_message_leaves_out_stay(defaults: Parameters) -> None:
    """An empty request changes nothing."""
    assert from_message(pb.Parameters(), defaults) == defaults


def test_live_ranges_are_what_the_message_can_carry(defaults: Parameters) -> None:
    """The screen may offer exactly the numbers that the vehicle takes in flight."""
    descriptor: Any = pb.Parameters.DESCRIPTOR
    carried = {
        f"{section.name}.{field.name}"
        for section in descriptor.fields
        for field in section.message_type.fields
        if section.name != "bumpless"
    }
    assert {r.path for r in RANGES if r.live} == carried


def test_a_message_out_of_range_is_refused_with_every_number(defaults: Parameters) -> None:
    """Protects: what comes over the bus is held against the same declarations as a file."""
    message = to_message(defaults)
    setattr(message.hover, "lambda", -1.0)
    message.supervisor.range_fr_lower_m = float("nan")
    message.forward.r_diagonal[2] = 0.0
    with pytest.raises(ParameterError) as caught:
        from_message(message, defaults)
    assert {problem.field for problem in caught.value.problems} == {
        "hover.lambda",
        "supervisor.range_fr_lower_m",
        "forward.r_diagonal[2]",
    }


def test_a_set_from_the_screen_must_be_whole_known_and_live(defaults: Parameters) -> None:
    """Protects: an absent number would become zero on the bus; what is not live can't be slipped in."""
    whole = {name: {k: as_dict(defaults)[name][k] for k in keys} for name, keys in live_fields().items()}
    assert live_problems(whole) == []
    whole["hover"].pop("lambda")
    whole["bumpless"].pop("ramp")
    whole["forward"]["kp"] = [1.0] * 6
    whole["supervisor"]["dwell_cycles"] = 0.5
    whole["guidance"] = {}
    told = {problem.field: problem.rule for problem in live_problems(whole)}
    assert told == {
        "guidance": "unknown field; one of forward, reverse, hover, supervisor, bumpless",
        "forward.kp": "may not change in flight",
        "hover.lambda": "is missing: λ, price of commands",
        "supervisor.dwell_cycles": "must be a whole number in cycles",
        "bumpless.ramp": "is missing",
    }
    assert live_problems([])[0].rule == "must be an object of parameters"
