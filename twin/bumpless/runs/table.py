"""A run as a table: one row per control cycle, one column per number, named after the contract.

Columns are "<topic>.<field>", such as "navigation.position_ned_m.x" or "control.demanded.x_n"; an
actuator's are "actuators.<name>.command_deg" or "..._rpm". Units are in the names. Modes and statuses are
their names in the contract. A cycle without a topic has NaN there, or "" for names.
"""

from collections.abc import Callable, Iterable
from operator import attrgetter
from typing import Any

import numpy as np
import numpy.typing as npt
from google.protobuf.descriptor import Descriptor, FieldDescriptor
from google.protobuf.message import Message

from bumpless.contract.keys import TOPICS
from bumpless.runs.names import TRUTH

Table = dict[str, npt.NDArray[Any]]

PER_CYCLE = {f"tlm/{name}": name for name, topic in TOPICS.items() if topic.rate_hz is None} | {
    TRUTH: "truth"
}
_HAVE_A_UNIT = (
    "command",
    "feedback",
    "lower",
    "upper",
    "amplitude_lower",
    "amplitude_upper",
    "increment_bound",
)
_STAMP = attrgetter("stamp.cycle", "stamp.mission_time_s", "stamp.time_ns")


def table_of(told: Iterable[tuple[str, Message]]) -> Table:
    """From messages as (topic, message); the first three columns are cycle, time_s and time_ns."""
    rows: dict[str, list[tuple[Any, ...]]] = {}
    stamps: dict[int, tuple[float, int]] = {}
    readers: dict[str, _Reader] = {}
    for topic, message in told:
        if topic not in PER_CYCLE:
            continue
        reader = readers.get(topic)
        if reader is None:
            reader = readers[topic] = _Reader(PER_CYCLE[topic], message)
            rows[topic] = []
        cycle, time_s, time_ns = _STAMP(message)
        stamps.setdefault(cycle, (time_s, time_ns))
        rows[topic].append((cycle, *reader.read(message)))
    cycles = sorted(stamps)
    table: Table = {
        "cycle": np.array(cycles, np.int64),
        "time_s": np.array([stamps[cycle][0] for cycle in cycles], float),
        "time_ns": np.array([stamps[cycle][1] for cycle in cycles], np.int64),
    }
    for topic, reader in sorted(readers.items(), key=lambda item: list(PER_CYCLE).index(item[0])):
        table |= reader.columns(rows[topic], table["cycle"])
    return table


class _Reader:
    """Reads messages of one kind; the actuators' number and names are those of the first."""

    def __init__(self, topic: str, message: Any) -> None:
        self._single = _fields(topic, message.DESCRIPTOR)
        self._get = _getter([path for _, path, _ in self._single])
        self._repeated, names = _repeated(topic, message)
        self._kinds = [field for *_, field in self._single] + [field for _, field in names]
        self.names = [name for name, *_ in self._single] + [name for name, _ in names]

    def read(self, message: Message) -> tuple[Any, ...]:
        """The message's numbers, in the order of `names`."""
        return (*self._get(message), *self._repeated(message))

    def columns(self, rows: list[tuple[Any, ...]], cycles: npt.NDArray[np.int64]) -> Table:
        """(cycle, numbers...) per message as columns over all cycles."""
        width = len(self.names) + 1
        rows = [row for row in rows if len(row) == width]  # one with another number of actuators has no place
        own, *values = zip(*rows, strict=True) if rows else [()] * width
        at = np.searchsorted(cycles, np.array(own, np.int64))
        made: Table = {}
        for name, field, column in zip(self.names, self._kinds, values, strict=True):
            if field.enum_type is not None:
                made[name] = np.full(len(cycles), "", object)
                made[name][at] = [_enum_name(field, number) for number in column]
            elif field.cpp_type == FieldDescriptor.CPPTYPE_STRING:
                made[name] = np.full(len(cycles), "", object)
                made[name][at] = column
            else:
                made[name] = np.full(len(cycles), np.nan)
                made[name][at] = column
        return made


def _getter(paths: list[str]) -> Callable[[Any], tuple[Any, ...]]:
    """Reads these attributes as a tuple, however many there are."""
    if len(paths) > 1:
        return attrgetter(*paths)
    return lambda message: tuple(attrgetter(path)(message) for path in paths)


def _enum_name(field: FieldDescriptor, number: int) -> str:
    """ "FORWARD" for MODE_FORWARD."""
    assert field.enum_type is not None
    numbers = field.enum_type.values_by_number
    known = numbers.get(number)
    if known is None:
        return str(number)
    prefix = numbers[0].name.removesuffix("UNSPECIFIED")
    return known.name.removeprefix(prefix)


def _fields(prefix: str, kind: Descriptor, path: str = "") -> list[tuple[str, str, FieldDescriptor]]:
    """(column, dotted path, field) of each number in a message, those inside its parts included."""
    found = []
    for field in kind.fields:
        if field.name == "stamp" or field.is_repeated:
            continue
        name, inner = f"{prefix}.{field.name}", f"{path}{field.name}"
        if field.message_type is not None:
            found += _fields(name, field.message_type, f"{inner}.")
        else:
            found.append((name, inner, field))
    return found


def _repeated(
    topic: str, message: Any
) -> tuple[Callable[[Any], tuple[Any, ...]], list[tuple[str, FieldDescriptor]]]:
    """How to read what a message has one of per command, and the names of it."""
    readers: list[Callable[[Any], Iterable[Any]]] = []
    names: list[tuple[str, FieldDescriptor]] = []
    for field in message.DESCRIPTOR.fields:
        if not field.is_repeated:
            continue
        items = getattr(message, field.name)
        if field.message_type is None:
            names += [(f"{topic}.{field.name}.{k}", field) for k in range(len(items))]
            readers.append(attrgetter(field.name))
            continue
        inner = [f for f in field.message_type.fields if f.name not in ("name", "unit")]
        for item in items:
            names += [(f"{topic}.{item.name}.{_with_unit(f.name, item.unit)}", f) for f in inner]
        readers.append(_items_reader(field.name, inner))
    return lambda m: tuple(number for read in readers for number in read(m)), names


def _items_reader(name: str, fields: list[FieldDescriptor]) -> Callable[[Any], list[Any]]:
    """The fields of every item of a repeated part, in turn; NaN for an optional one that is not there."""
    get = _getter([field.name for field in fields])
    optional = [(k, field.name) for k, field in enumerate(fields) if field.has_presence]

    def read(message: Any) -> list[Any]:
        found: list[Any] = []
        for item in getattr(message, name):
            values = list(get(item))
            for k, option in optional:
                if not item.HasField(option):
                    values[k] = np.nan
            found += values
        return found

    return read


def _with_unit(name: str, unit: str) -> str:
    return f"{name}_{unit}" if name in _HAVE_A_UNIT and unit else name
