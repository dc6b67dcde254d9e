"""What YAML means in a mission: the 1.2 core schema, places, and bounds on hostile files."""

import json
import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from bumpless.config.yaml_text import YamlText


def value(text: str) -> object:
    file = YamlText(f"a: {text}\n", "x.yaml")
    assert file.problems == []
    assert file.value is not None
    return file.value["a"]


@pytest.mark.parametrize(
    ("text", "means"),
    [
        ("045", 45),
        ("007", 7),
        ("[010, 0, 2]", [10, 0, 2]),
        ("-045.5", -45.5),
        ("+3", 3),
        ("089", 89),
        ("1e3", 1000.0),
        (".5", 0.5),
        ("5.", 5.0),
        ("0o17", 15),
        ("0x1F", 31),
        ("1_000", "1_000"),
        ("1:30", "1:30"),
        ("0b11", "0b11"),
        ("yes", "yes"),
        ("2026-11-25", "2026-11-25"),
        ("'045'", "045"),
        ('"1"', "1"),
        ("true", True),
        ("FALSE", False),
        ("~", None),
        ("", None),
        ("'null'", "null"),
        (".inf", math.inf),
        ("-.INF", -math.inf),
        (f"{10**400}", math.inf),
        (f"-{10**400}", -math.inf),
        ("1" * 5000, math.inf),
    ],
)
def test_scalars_mean_what_yaml_1_2_says(text: str, means: object) -> None:
    """Protects: headings of three digits are decimal; no word or clock time becomes a number."""
    assert value(text) == means
    assert type(value(text)) is type(means)


@given(st.integers(0, 359), st.integers(0, 4))
def test_leading_zeros_never_change_a_number(number: int, zeros: int) -> None:
    """Protects: no octal of YAML 1.1 in a heading."""
    assert value("0" * zeros + str(number)) == number


@pytest.mark.parametrize(
    ("text", "place", "rule"),
    [
        ("a: 1\nb: &x 2\n", (2, 4), "anchors and aliases"),
        ("a: 1\nb: *x\n", (2, 4), "anchors and aliases"),
        ("a: &a [&b [1], *b]\n", (1, 4), "anchors and aliases"),
        ("a: !!str 5\n", (1, 4), "tags are not used"),
        ("a: !python/object:os.system 5\n", (1, 4), "tags are not used"),
        ("? [1, 2]\n: 3\n", (1, 3), "must be the name of a field"),
        ("a:\n  b: {c: {d: {e: {f: {g: 1}}}}}\n", (2, 22), "nested too deeply"),
        ("a: 1\n--- {}\n", (2, 1), "a second document"),
        ("a: 1\n\tb: 2\n", (2, 1), "not valid YAML"),
        ("a: 1\nb: [1, 2\n", (3, 1), "not valid YAML"),
        ('a: "\\ud800"\n', (1, 7), "half of a character"),
    ],
)
def test_what_missions_do_not_use_is_refused_at_its_place(
    text: str, place: tuple[int, int], rule: str
) -> None:
    """Protects: no bomb and no code in a mission; each refusal says where."""
    (problem,) = YamlText(text, "x.yaml").problems
    assert (problem.line, problem.column) == place
    assert rule in problem.rule


def test_a_bomb_of_aliases_costs_nothing() -> None:
    """Protects: the first anchor ends the reading, whatever would come of it."""
    lines = ["a0: &a0 [x, x, x, x, x, x, x, x, x]"]
    lines += [f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 9)}]" for i in range(1, 30)]
    file = YamlText("\n".join(lines), "bomb.yaml")
    assert file.value is None
    assert len(file.problems) == 1


def test_each_duplicate_is_told_at_its_place() -> None:
    """Protects: of two values neither is taken silently, at any depth."""
    file = YamlText("a: 1\nb: {c: 1, c: [2]}\na: 3\n", "x.yaml")
    assert [(p.line, p.column, p.field, p.value) for p in file.problems] == [
        (2, 11, "b.c", [2]),
        (3, 1, "a", 3),
    ]
    assert all("appears twice" in p.rule for p in file.problems)


_PLAIN = st.recursive(
    st.none()
    | st.booleans()
    | st.integers(-(10**9), 10**9)
    | st.floats(-1e9, 1e9)
    | st.text("ab 1.:-#'\"", max_size=5),
    lambda inner: (
        st.lists(inner, max_size=3)
        | st.dictionaries(st.text("abc", min_size=1, max_size=2), inner, max_size=3)
    ),
    max_leaves=8,
)


@given(st.dictionaries(st.text("abcd", min_size=1, max_size=3), _PLAIN, min_size=1, max_size=4))
def test_json_is_read_as_json(tree: dict[str, object]) -> None:
    """Protects: JSON is YAML; every value arrives unchanged."""
    file = YamlText(json.dumps(tree), "x.json")
    assert file.value == tree or any("deeply" in problem.rule for problem in file.problems)
