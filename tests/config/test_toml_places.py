"""Line and column of every field of a TOML text, however it is written."""

import tomllib
from typing import Any

from hypothesis import given
from hypothesis import strategies as st

from bumpless.config.toml_places import places_of
from bumpless.config.vehicle import FOLDER

EVERY_WAY = '''\
title = "a # b" # c
physical.color = 'orange'
"quoted key" = 1
list = [1, [2, 3], # comment ]
  { x = 1, "y z" = "}" },
]
long = """
not = 1
\\"""" # end
[table]
  in_it = 1
[table.sub.deep]
a = 1979-05-27T07:32:00Z
[[entries]]
name = "one"
point = { x = 1.0, y = { z = 2 } }
[[entries]]
name = \'\'\'two\'\'\'
[entries.detail]
size = -1e3
[[entries.inner]]
v = inf
'''


def test_every_way_of_writing_is_followed() -> None:
    """Protects: inline tables, dotted and quoted keys, arrays of tables and long strings have places."""
    places = places_of(EVERY_WAY)
    assert places["title"] == (1, 1)
    assert (places["physical"], places["physical.color"]) == ((2, 1), (2, 10))
    assert places["quoted key"] == (3, 1)
    assert (places["list[0]"], places["list[1][1]"], places["list[2].y z"]) == ((4, 9), (4, 16), (5, 12))
    assert places["long"] == (7, 1)
    assert (places["table"], places["table.in_it"]) == ((10, 1), (11, 3))
    assert places["table.sub.deep.a"] == (13, 1)
    assert places["entries[0].point.y.z"] == (16, 26)
    assert (places["entries[1]"], places["entries[1].name"]) == ((17, 1), (18, 1))
    assert places["entries[1].detail.size"] == (20, 1)
    assert places["entries[1].inner[0].v"] == (22, 1)


def paths(value: Any, path: str = "") -> list[str]:
    found = [path] if path else []
    if isinstance(value, dict):
        return found + [p for k, v in value.items() for p in paths(v, f"{path}.{k}" if path else k)]
    if isinstance(value, list):
        return found + [p for i, v in enumerate(value) for p in paths(v, f"{path}[{i}]")]
    return found


def test_every_field_of_the_shipped_vehicles_has_its_place() -> None:
    """Protects: no rule about a vehicle lacks its line and column."""
    for file in FOLDER.glob("*.toml"):
        text = file.read_text(encoding="utf-8")
        places, lines = places_of(text), text.splitlines()
        for path in paths(tomllib.loads(text)):
            if path in places and not path.endswith("]"):
                line, column = places[path]
                there = lines[line - 1][column - 1 :]
                assert there.startswith((path.rpartition(".")[2], "[")), path
            else:  # a table that only its sub-tables name, or an entry of a list
                assert any(other.startswith((path, path + ".")) for other in places), path


_KEY = st.sampled_from(["a", "b", "c-1", '"q k"', "'l.k'"])
_SCALAR = st.sampled_from(
    ["1", "-2.5e3", "true", '"t # ="', "'l ]'", '"""m\n]"""', "'''n\n}'''", "inf", "1979-05-27"]
)
_GAP = st.sampled_from(["", " ", "  "])
_VALUE = st.recursive(
    _SCALAR,
    lambda inner: (
        st.tuples(st.lists(inner, max_size=3), st.sampled_from([", ", ",", " ,\n # ] x\n "])).map(
            lambda t: "[" + t[1].join(t[0]) + "]"
        )
        | st.dictionaries(_KEY, inner, max_size=3).map(
            lambda d: "{" + ", ".join(f"{k} = {v}" for k, v in d.items()) + "}"
        )
    ),
    max_leaves=6,
)


@given(
    st.lists(
        st.tuples(st.sampled_from(["", "[t]", "[t.u]", "[[r]]", "[r.s]", "# [no]"]), _KEY, _GAP, _VALUE),
        max_size=8,
    )
)
def test_any_toml_has_a_place_for_each_field(parts: list[tuple[str, str, str, str]]) -> None:
    """Protects: whatever tomllib reads, the scanner follows to the same fields."""
    text = "".join(f"{header}\n{gap}{key}{gap}={gap}{value} # c\n" for header, key, gap, value in parts)
    try:
        tree = tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return
    places = places_of(text)
    lines = text.split("\n")
    for path in paths(tree):
        nameless = path in ("t", "r")
        assert path in places or nameless, (path, text)
        if path in places:
            line, column = places[path]
            assert lines[line - 1][column - 1 :]
    assert {p for p in places if p not in paths(tree)} == set()
