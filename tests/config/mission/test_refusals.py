"""A bad mission is refused with file, line, column, field, value and rule, and all faults at once."""

import pytest

from bumpless.config.mission import MissionError, parse_mission
from bumpless.config.problems import Problem
from bumpless.config.vehicle import Vehicle


def refused(text: str, vehicle: Vehicle | None = None) -> tuple[Problem, ...]:
    with pytest.raises(MissionError) as caught:
        parse_mission(text, "bad.yaml", vehicle)
    assert all(problem.file == "bad.yaml" for problem in caught.value.problems)
    return caught.value.problems


def test_a_fault_names_its_place_field_value_and_rule(good: str, ts100: Vehicle) -> None:
    """What a person needs to mend the file stands in one line."""
    (problem,) = refused(good.replace("speed_mps: 0.7", "speed_mps: 9"), ts100)
    assert (problem.line, problem.column, problem.field, problem.value) == (7, 30, "legs[0].speed_mps", 9)
    assert str(problem) == "bad.yaml:7:30: legs[0].speed_mps = 9; must be between 0.01 and 5 in m/s"


@pytest.mark.parametrize(
    ("change", "field", "rule"),
    [
        (("[22, 0, 2.5]", "[22, 0, -2.5]"), "target.position_ned_m[2]", "depth is positive down"),
        (("[0, 0, 2]", "[0, 0, -1]"), "start.position_ned_m[2]", "depth is positive down"),
        (("[20, 0, 2.5]", "[20, 0, .nan]"), "legs[0].to_ned_m[2]", "finite"),
        (("[20, 0, 2.5]", "[20, .inf, 2.5]"), "legs[0].to_ned_m[1]", "finite"),
        (("[20, 0, 2.5]", "[20, 0]"), "legs[0].to_ned_m", "list of 3 numbers in m: [north, east, down]"),
        (("[20, 0, 2.5]", "[0, 0, 2]"), "legs[0].to_ned_m", "must end at least 0.5 m"),
        (("duration_s: 60", "duration_s: 60 s"), "duration_s", "without its unit"),
        (("duration_s: 60", "duration_s: true"), "duration_s", "must be a number in s"),
        (("duration_s: 60", "duration: 60"), "duration", "did you mean duration_s?"),
        (("heading_deg: 0}", "heading_rad: 0}"), "start.heading_rad", "did you mean heading_deg?"),
        (("name: short", "name: ../short"), "name", "letters, digits"),
        (("name: short", "name: [a]"), "name", "must be a text"),
        (("version: 1", "version: 2"), "version", "must be 1"),
        (("vehicle: ts100", "vehicle: other"), "vehicle", "must be ts100"),
        (("version: 1", "version: 1\nversion: 1"), "version", "appears twice; first on line 1"),
        (("version: 1", "version: 1\nseed: 1.5"), "seed", "whole number"),
        (("version: 1", f"version: 1\nseed: {10**400}"), "seed", "must be a finite number"),
        (
            ("version: 1", f"version: 1\nparameters: {{hover: {{lambda: {10**400}}}}}"),
            "parameters.hover.lambda",
            "must be a finite number",
        ),
        (("version: 1", 'version: 1\ntitle: "half \\ud800"'), "", "holds half of a character"),
        (("version: 1", "version: 1\nfaults: 3"), "faults", "must be a list"),
        (("version: 1", "version: 1\nend: 3"), "end", "must hold named fields"),
        (
            ("standoff_m: 1.5", "standoff_m: 1.5, true_offset_ned_m: [0, 0, -3]"),
            "target.true_offset_ned_m",
            "must keep the target under water (depth -0.5 m)",
        ),
        (
            ("version: 1", "version: 1\nend: {hover_hold_s: 90}"),
            "end.hover_hold_s",
            "shorter than duration_s",
        ),
        (
            ("version: 1", "version: 1\nsensors: {outages: [{from_s: 5, to_s: 5}]}"),
            "sensors.outages[0].to_s",
            "must be after from_s (5)",
        ),
        (
            ("version: 1", "version: 1\nfaults: [{actuator: sail, at_s: 1, effectiveness: 0}]"),
            "faults[0].actuator",
            "unknown actuator; one of ",
        ),
        (
            ("version: 1", "version: 1\nparameters: {hover: {lamda: 1}}"),
            "parameters.hover.lamda",
            "unknown field",
        ),
        (
            ("version: 1", "version: 1\nparameters: {supervisor: {range_rh_upper_m: 30}}"),
            "parameters.supervisor.range_fr_lower_m",
            "must be greater than range_rh_upper_m (30)",
        ),
        (
            ("version: 1", "version: 1\nparameters: {hover: {q_diagonal: [1, 2]}}"),
            "parameters.hover.q_diagonal",
            "must be a list of 6 numbers in 1/N² or 1/(N·m)²: [X, Y, Z, K, M, N]",
        ),
    ],
)
def test_broken_rules(good: str, ts100: Vehicle, change: tuple[str, str], field: str, rule: str) -> None:
    """One change each, one rule each; the fault stands at a place in the file."""
    problems = refused(good.replace(*change), ts100)
    found = [p for p in problems if p.field == field]
    assert found, [str(p) for p in problems]
    assert rule in found[0].rule
    assert found[0].line
    assert found[0].column


def test_a_missing_field_is_named_with_its_unit(good: str, ts100: Vehicle) -> None:
    """The fault of something absent stands where it should have been."""
    (problem,) = refused(good.replace(", standoff_m: 1.5", ""), ts100)
    assert (problem.line, problem.field, problem.value) == (8, "target.standoff_m", None)
    assert problem.rule.startswith("is missing: Distance of the observation point")
    assert problem.rule.endswith("in m")


def test_all_faults_come_at_once_in_the_order_of_the_file(good: str, ts100: Vehicle) -> None:
    """Nobody should mend a file one fault at a time."""
    text = good.replace("duration_s: 60", "duration_s: -1").replace("0.7", "fast").replace("1.5}", "-1}")
    assert [p.field for p in refused(text, ts100)] == ["duration_s", "legs[0].speed_mps", "target.standoff_m"]


@pytest.mark.parametrize(
    ("text", "rule"),
    [
        ("", "must hold named fields"),
        ("- 1\n", "must hold named fields"),
        ("a: [", "not valid YAML"),
        ("a: 1\n\tb: 2\n", "not valid YAML"),
        ("a: \x00\n", "not valid YAML"),
        ("a: 1\n---\nb: 2\n", "not valid YAML"),
        ("a: &x [*x]\n", "anchors and aliases"),
        ("a: &x [1]\nb: *x\n", "anchors and aliases"),
        ("parameters: " + "[" * 5000, "nested too deeply"),
        ("parameters: [[[[[[[[[1]]]]]]]]]\n", "nested too deeply"),
        ("a: " + "x" * 140_000, "longer than"),
    ],
)
def test_what_is_no_mission_at_all(text: str, rule: str) -> None:
    """Broken, hostile or foreign text ends in a plain refusal, never in another error."""
    assert any(rule in problem.rule for problem in refused(text))


def test_an_unknown_vehicle_is_named(good: str) -> None:
    """Without a vehicle given, the one that the mission asks for must exist."""
    (problem,) = refused(good.replace("vehicle: ts100", "vehicle: ts9000"))
    assert problem.field == "vehicle"
    assert "ts100" in problem.rule


def test_faults_of_fields_and_of_parameters_come_together(good: str, ts100: Vehicle) -> None:
    """Protects: overrides are checked even when another field of the mission can't be read."""
    text = good.replace("0.7", "fast") + "parameters: {hover: {lamda: 1, ramp_cycles: 2.5}, supervisor: 3}\n"
    for vehicle in (ts100, None):
        assert [p.field for p in refused(text, vehicle)] == [
            "legs[0].speed_mps",
            "parameters.hover.lamda",
            "parameters.hover.ramp_cycles",
            "parameters.supervisor",
        ]


def test_null_where_a_number_must_stand(good: str, ts100: Vehicle) -> None:
    """Protects: an empty value is told as such, not as missing."""
    (problem,) = refused(good.replace("duration_s: 60", "duration_s:"), ts100)
    assert str(problem) == "bad.yaml:4:1: duration_s = null; must be a number in s"


def test_text_that_yaml_takes_for_a_number(good: str, ts100: Vehicle) -> None:
    """Protects: schema and reader agree that a title of digits needs quotes."""
    (problem,) = refused(good + "title: 2026\n", ts100)
    assert problem.rule == "must be a text: put it in quotes"
