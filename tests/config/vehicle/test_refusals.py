"""A bad vehicle file is refused with file, line, field, value and rule; never half-loaded."""

import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bumpless.config.parameters import ParameterError, default_parameters
from bumpless.config.problems import Problem
from bumpless.config.vehicle import FOLDER, VehicleError, load_vehicle, parse_vehicle

JUNK = [
    "[]",
    "{}",
    '""',
    '"x"',
    "nan",
    "-inf",
    "true",
    "-5",
    "0",
    "[[1]]",
    "[1, 2]",
    "1979-05-27",
    "{ kind = 3 }",
]
GOOD = (FOLDER / "ts100.toml").read_text(encoding="utf-8")


def refused(old: str, new: str) -> tuple[Problem, ...]:
    """Problems of the TS-100's file after one replacement."""
    assert GOOD.count(old) >= 1, f"{old!r} is not in the file"
    with pytest.raises(VehicleError) as error:
        parse_vehicle(GOOD.replace(old, new, 1), "ts100.toml")
    return error.value.problems


@pytest.mark.parametrize(
    ("old", "new", "field", "rule"),
    [
        ("mass_kg = 60.0", "mass_kg = -1", "mass.mass_kg", "must be > 0"),
        ("mass_kg = 60.0", "mass_kg = nan", "mass.mass_kg", "must be a finite number in kg"),
        ("mass_kg = 60.0", 'mass_kg = "sixty"', "mass.mass_kg", "must be a number in kg"),
        ("mass_kg = 60.0", 'mass_kg = "60 kg"', "mass.mass_kg", "must be a number in kg, without its unit"),
        ("mass_kg = 60.0", "mass_kg = true", "mass.mass_kg", "must be a number in kg"),
        ("center_of_gravity_m = [0.0, 0.0, 0.010]", "center_of_gravity_m = [0.0, 0.0]",
         "mass.center_of_gravity_m", "must be a list of 3 numbers in m: [x, y, z]"),
        ('kind = "myring"', 'kind = "brick"', "hull.kind", "must be one of myring, tabulated"),
        ('controllable = ["X", "Z"', 'controllable = ["X", "X"', "controllable", "each once"),
        ("control_period_s = 0.05", "control_period_s = 0", "control_period_s", "must be > 0"),
        ('type = "rudder"', 'type = "sail"', "actuators[0].type", "must name a table of actuator_types"),
        ('name = "delta_2"', 'name = "delta_1"', "actuators[1].name", "must be different"),
        ("direction = [1.0, 0.0, 0.0]", "direction = [0.0, 0.0, 0.0]", "actuators[4].direction", "not be 0"),
        ("range_max_m = 12.0", "range_max_m = 0.1", "sensors.camera.range_max_m", "must be > range_min_m"),
        ("dropout_probability = 0.005", "dropout_probability = 2", "sensors.dvl.dropout_probability",
         "between 0 and 1"),
    ],
)  # fmt: skip
def test_one_wrong_value_gives_one_problem_that_names_it(old: str, new: str, field: str, rule: str) -> None:
    """Each rule of the file's fields, alone."""
    (problem,) = refused(old, new)
    assert problem.file == "ts100.toml"
    assert problem.field == field
    assert rule in problem.rule


def test_missing_and_unknown_fields_are_named() -> None:
    """A misspelt field shows as unknown and as missing, so that nobody flies with a default by accident."""
    problems = refused("mass_kg = 60.0", "mas_kg = 60.0")
    assert sorted((p.field, p.rule) for p in problems) == [
        ("mass.mas_kg", "unknown field; did you mean mass_kg?"),
        ("mass.mass_kg", "is missing: Mass in kg"),
    ]


def test_all_problems_come_at_once_with_their_lines() -> None:
    """An operator mends a file in one go."""
    bad = GOOD.replace("mass_kg = 60.0", "mass_kg = 0").replace("rate_hz = 10.0", "rate_hz = -3", 1)
    with pytest.raises(VehicleError) as error:
        parse_vehicle(bad, "ts100.toml")
    mass, rate = error.value.problems
    lines = bad.splitlines()
    assert mass.line and lines[mass.line - 1].startswith("mass_kg")
    assert rate.line and lines[rate.line - 1].startswith("rate_hz")
    assert str(mass) == f"ts100.toml:{mass.line}:1: mass.mass_kg = 0; must be > 0 in kg"


def test_text_that_is_not_toml_names_its_line() -> None:
    """The parser's own place is passed on."""
    (problem,) = refused("[mass]", "[mass")
    assert problem.line == GOOD.splitlines().index("[mass]") + 1
    assert "is not TOML" in problem.rule


def test_too_many_actuators_are_refused() -> None:
    """The records hold eight."""
    extra = '\n[[actuators]]\nname = "more_{}"\ntype = "rudder"\nradial_direction_deg = 0.0\n'
    with pytest.raises(VehicleError, match="must have between 1 and 8 entries"):
        parse_vehicle(GOOD + extra.format(1) + extra.format(2), "big.toml")


def test_an_unknown_vehicle_is_told_which_there_are() -> None:
    """A typing error on the command line."""
    with pytest.raises(VehicleError, match="ts100"):
        load_vehicle("ts1000")


def test_problem_reads_like_a_sentence() -> None:
    """The one line that every screen and command prints."""
    assert str(Problem("ts100.toml", None, None, "thrusters[1].thrust_max_n", -0.5, "must be > 0")) == (
        "ts100.toml: thrusters[1].thrust_max_n = -0.5; must be > 0"
    )
    assert str(Problem("a.yaml", 3, 5, "legs[0]", None, "is missing")) == "a.yaml:3:5: legs[0]; is missing"


@given(place=st.integers(0, 10_000), junk=st.sampled_from(JUNK), cut=st.booleans())
def test_no_damage_raises_anything_but_a_refusal(place: int, junk: str, cut: bool) -> None:
    """Any one line damaged or lost: the file still loads or is refused with problems, never a traceback."""
    lines = GOOD.splitlines()
    at = place % len(lines)
    lines[at] = "" if cut else re.sub(r"=.*", f"= {junk}", lines[at])
    try:
        parse_vehicle("\n".join(lines), "damaged.toml")
    except VehicleError as error:
        assert error.problems
        assert all(str(problem).startswith("damaged.toml") for problem in error.problems)


@pytest.mark.parametrize("junk", JUNK)
@pytest.mark.parametrize(
    "table",
    ["environment", "mass", "hull", "appendages", "actuator_types", "actuators", "sensors", "control"],
)
def test_a_table_may_be_anything_and_is_still_refused_politely(table: str, junk: str) -> None:
    """A file whose tables are not tables."""
    with pytest.raises(VehicleError):
        parse_vehicle(f"{table} = {junk}", "wrong.toml")


def placed(text: str, field: str) -> tuple[str, int | None, int | None]:
    with pytest.raises(VehicleError) as error:
        parse_vehicle(text, "x.toml")
    return next((p.file, p.line, p.column) for p in error.value.problems if p.field == field)


def test_a_fault_in_shared_fields_is_told_where_it_is_written() -> None:
    """Protects: a wrong number of a type is shown at the type, not at an actuator that doesn't hold it."""
    bad = GOOD.replace("span_m = 0.11674 ", "  span_m = -0.11674 ")
    line = next(i for i, text in enumerate(bad.splitlines(), 1) if "span_m = -" in text)
    assert placed(bad, "actuators[0].span_m") == ("x.toml", line, 3)
    assert placed(bad, "actuators[3].span_m") == ("x.toml", line, 3)


def test_inline_tables_and_dotted_keys_have_their_places() -> None:
    """Protects: line and column, however TOML writes a field."""
    head = GOOD.split("[environment]")[0]
    text = head + "environment = { water_density_kgpm3 = -1, gravity_mps2 = 9.8 }\nmass.mass_kg = 0\n"
    line = len(head.splitlines()) + 1
    assert placed(text, "environment.water_density_kgpm3") == ("x.toml", line, 17)
    assert placed(text, "mass.mass_kg") == ("x.toml", line + 1, 6)
    assert placed(text, "mass.displaced_volume_m3") == ("x.toml", line + 1, 1)
    assert placed(text, "hull") == ("x.toml", 1, 1)
    body = GOOD.replace("center_of_gravity_m = [0.0, 0.0, 0.010]", 'center_of_gravity_m = [0.0, "a", 0.010]')
    line = next(i for i, text in enumerate(body.splitlines(), 1) if '"a"' in text)
    assert placed(body, "mass.center_of_gravity_m[1]") == ("x.toml", line, 29)


@pytest.mark.parametrize(
    ("control", "line", "column", "field"),
    [
        ("# gains\n[control.hover]\nlambda = -1\n", 3, 1, "hover.lambda"),
        ("[control.supervisor]\n\n  range_rh_lower = 1\n", 3, 3, "supervisor.range_rh_lower"),
    ],
)
def test_faults_of_the_control_file_are_told_in_that_file(
    tmp_path: Path, control: str, line: int, column: int, field: str
) -> None:
    """Protects: the two files are read as one text, but each fault stands in the file that holds it."""
    (tmp_path / "mine.toml").write_text(GOOD, encoding="utf-8")
    (tmp_path / "mine.control.toml").write_text(control, encoding="utf-8")
    with pytest.raises(ParameterError) as error:
        default_parameters(load_vehicle(tmp_path / "mine.toml"))
    found = next(p for p in error.value.problems if p.field == field)
    assert (found.file, found.line, found.column) == ("mine.control.toml", line, column)


def test_a_control_file_that_is_not_toml_is_named(tmp_path: Path) -> None:
    """Protects: the place of a syntax error is in the right file too."""
    (tmp_path / "mine.toml").write_text(GOOD, encoding="utf-8")
    (tmp_path / "mine.control.toml").write_text("[control.hover]\nlambda =\n", encoding="utf-8")
    with pytest.raises(VehicleError) as error:
        load_vehicle(tmp_path / "mine.toml")
    (problem,) = error.value.problems
    assert (problem.file, problem.line) == ("mine.control.toml", 2)


def test_an_actuator_of_no_known_kind_is_refused() -> None:
    """Protects: `kind` chooses the fields; without it nothing else is guessed."""
    (unknown,) = refused('name = "n_p"\nkind = "thruster"', 'name = "n_p"\nkind = "sail"')
    assert (unknown.field, unknown.rule) == ("actuators[4].kind", "must be one of fin, thruster, azimuth")
    (absent,) = refused('name = "n_p"\nkind = "thruster"', 'name = "n_p"')
    assert (absent.field, absent.value, absent.rule) == (
        "actuators[4].kind",
        None,
        "is missing: one of fin, thruster, azimuth",
    )
