"""What one field of a file may hold, said once: its type, unit, range, label, help, record.

A field is declared as `speed_mps: Annotated[float, Number("Speed", "m/s", 0.0, 5.0)] = 0.0`. pydantic asks
the note for the check (`__get_pydantic_core_schema__`); `schema`, `catalogue`, `record` and `reference` read
the same note. What a person reads when a value breaks the rule is made by the note too.
"""

import math
import re
from collections.abc import Callable
from dataclasses import KW_ONLY, dataclass
from types import UnionType
from typing import Any, Union, get_args, get_origin

from pydantic import GetCoreSchemaHandler, ValidationError
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from bumpless.config.plain import is_row

_WITH_UNIT = re.compile(r"\s*[-+.\d]+\s*[A-Za-z°/]+")


def without_none(kind: Any) -> tuple[Any, bool]:
    """The type without None, and whether None was among its options."""
    if get_origin(kind) not in (Union, UnionType):
        return kind, False
    options = [option for option in get_args(kind) if option is not type(None)]
    optional = len(options) < len(get_args(kind))
    return (options[0] if len(options) == 1 else Union[tuple(options)]), optional  # noqa: UP007


def refusal(rule: str) -> PydanticCustomError:
    """The error that carries a rule to the reader, word for word."""
    return PydanticCustomError("rule", "{rule}", {"rule": rule})


def in_words(schema: CoreSchema, rule: Callable[[Any], str]) -> CoreSchema:
    """The schema with `rule` in place of pydantic's own words."""

    def said(value: Any, inner: Callable[[Any], Any]) -> Any:
        try:
            return inner(value)
        except ValidationError:
            raise refusal(rule(value)) from None

    return core_schema.no_info_wrap_validator_function(said, schema)


@dataclass(frozen=True)
class Note:
    """What all fields have: a short name for people, longer help, and whether it may change in flight."""

    label: str
    unit: str = ""
    _: KW_ONLY
    help: str = ""
    live: bool = False
    record: str = ""  # field of the compiled world's record: "d_rh_l", or "fault_gains[0]" for a row of one

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        kind, optional = without_none(source)
        schema = self.core(kind, handler)
        return core_schema.nullable_schema(schema) if optional else schema

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: Any) -> dict[str, Any]:
        return {"title": self.label, "description": self.described, **self._more, **handler(schema)}

    @property
    def described(self) -> str:
        """Label, help and unit in one line."""
        return self.label + (f", {self.unit}" if self.unit else "") + (f". {self.help}" if self.help else "")

    @property
    def _more(self) -> dict[str, Any]:
        return {"unit": self.unit} if self.unit else {}

    @property
    def in_unit(self) -> str:
        """ " in m", or nothing for what has no unit."""
        return f" in {self.unit}" if self.unit else ""

    def core(self, kind: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """pydantic's check of a value of `kind`."""
        return handler(kind)


@dataclass(frozen=True)
class Number(Note):
    """A finite number in `unit`: at least `min`, at most `max`, more than `above` where they are given."""

    min: float | None = None
    max: float | None = None
    _: KW_ONLY
    above: float | None = None
    hint: str = ""  # said after the bounds
    stored: type | None = None  # float: a whole number that the record holds as a float

    def core(self, kind: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        if kind is int:
            low, high = (None if x is None else int(x) for x in (self.min, self.max))
            schema = core_schema.int_schema(strict=True, ge=low, le=high)
            schema = core_schema.no_info_before_validator_function(_whole, schema)
        else:
            schema = core_schema.float_schema(
                strict=True, allow_inf_nan=False, gt=self.above, ge=self.min, le=self.max
            )
        return in_words(schema, lambda value: self.rule(kind, value))

    def rule(self, kind: Any, value: Any) -> str:
        """Which rule `value` breaks."""
        if isinstance(value, bool) or not isinstance(value, int | float):
            return f"must be a number{self.in_unit}" + (
                ", without its unit" if isinstance(value, str) and _WITH_UNIT.match(value) else ""
            )
        if not _finite(value):
            return f"must be a finite number{self.in_unit}"
        if kind is int and not float(value).is_integer():
            return f"must be a whole number{self.in_unit}"
        return self.bounds + (f": {self.hint}" if self.hint else "")

    @property
    def bounds(self) -> str:
        """ "must be between 0 and 5 in m/s"."""
        low, high = self.min, self.max
        if low is not None and low == high:
            return f"must be {low:g}"
        if low is not None and high is not None:
            return f"must be between {low:.10g} and {high:.10g}{self.in_unit}"
        sides = ((">", self.above), (">=", low), ("<=", high))
        said = " and ".join(f"{sign} {bound:.10g}" for sign, bound in sides if bound is not None)
        return f"must be {said}{self.in_unit}"


def _whole(value: Any) -> Any:
    return int(value) if isinstance(value, float) and value.is_integer() else value


def _finite(value: float) -> bool:
    try:
        return math.isfinite(value)
    except OverflowError:  # a whole number that no float holds
        return False


@dataclass(frozen=True)
class Row(Note):
    """A row of numbers, one for each of `names`; with no names one for each command, `most` of them at most.

    `min` and `max` hold for every number, or are rows themselves.
    """

    min: float | tuple[float, ...] | None = None
    max: float | tuple[float, ...] | None = None
    _: KW_ONLY
    names: tuple[str, ...] = ()
    hints: tuple[str, ...] = ()  # said after the bounds of each
    most: int = 0
    nonzero: bool = False  # a direction: some number must not be 0

    def numbers(self) -> list[Number]:
        """The declaration of each number; one that stands for all when there are no names."""

        def at(bound: float | tuple[float, ...] | None, i: int) -> float | None:
            return bound[i] if isinstance(bound, tuple) else bound

        return [
            Number(
                name,
                self.unit,
                at(self.min, i),
                at(self.max, i),
                hint=self.hints[i] if self.hints else "",
            )
            for i, name in enumerate(self.names or ("",))
        ]

    def core(self, kind: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        items = [number.core(float, handler) for number in self.numbers()]
        if not self.names:
            schema = core_schema.tuple_variable_schema(items[0])
        else:
            schema = core_schema.tuple_positional_schema(items)
        return core_schema.no_info_before_validator_function(self._shaped, schema)

    def _shaped(self, value: Any) -> Any:
        if is_row(value):
            fewest, most = (len(self.names),) * 2 if self.names else (1, self.most)
            if fewest <= len(value) <= most:
                if self.nonzero and all(number is not False and number == 0 for number in value):
                    raise refusal("must not be 0")
                return value
        raise refusal(self.shape)

    @property
    def _more(self) -> dict[str, Any]:
        length = {} if self.names else {"minItems": 1, "maxItems": self.most}
        return super()._more | length | ({"contains": {"not": {"const": 0}}} if self.nonzero else {})

    @property
    def shape(self) -> str:
        """ "must be a list of 3 numbers in m: [north, east, down]"."""
        if not self.names:
            return f"must be a list of numbers{self.in_unit}, one per command"
        return f"must be a list of {len(self.names)} numbers{self.in_unit}: [{', '.join(self.names)}]"

    @property
    def described(self) -> str:
        names = f" [{' '.join(self.names)}]" if self.names else ", one per command"
        return (
            self.label
            + names
            + (f", {self.unit}" if self.unit else "")
            + (f". {self.help}" if self.help else "")
        )


@dataclass(frozen=True)
class Choice(Note):
    """One of the words of a `Literal`; its record holds the word's place among them, from 0."""

    def core(self, kind: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        schema, rule = (
            core_schema.literal_schema(list(get_args(kind))),
            "must be one of " + ", ".join(get_args(kind)),
        )
        # One word chooses among models, and there pydantic wants to see it plain.
        return in_words(schema, lambda _: rule) if len(get_args(kind)) > 1 else schema


@dataclass(frozen=True)
class Switch(Note):
    """True or false; its record holds 1 or 0."""

    def core(self, kind: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return in_words(core_schema.bool_schema(strict=True), lambda _: "must be true or false")


@dataclass(frozen=True)
class Text(Note):
    """A text; of the form `pattern` (a regular expression) if there is one, which `form` words."""

    _: KW_ONLY
    pattern: str = ""
    form: str = ""

    def core(self, kind: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        pattern = f"^(?:{self.pattern})$" if self.pattern else None
        return in_words(core_schema.str_schema(strict=True, pattern=pattern), self.rule)

    def rule(self, value: Any) -> str:
        """Which rule `value` breaks."""
        if isinstance(value, bool | int | float):
            return "must be a text: put it in quotes"
        return self.form if isinstance(value, str) else "must be a text"


@dataclass(frozen=True)
class Words(Note):
    """A list of different words out of `options`, at least one."""

    _: KW_ONLY
    options: tuple[str, ...] = ()

    def core(self, kind: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        items = core_schema.literal_schema(list(self.options))
        schema = core_schema.tuple_variable_schema(items, min_length=1)
        schema = core_schema.no_info_after_validator_function(self._different, schema)
        return in_words(schema, lambda _: self._rule)

    @property
    def _rule(self) -> str:
        return "must list some of " + ", ".join(self.options) + ", each once"

    def _different(self, value: tuple[str, ...]) -> tuple[str, ...]:
        if len(set(value)) < len(value):
            raise refusal(self._rule)
        return value

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: Any) -> dict[str, Any]:
        return super().__get_pydantic_json_schema__(schema, handler) | {"uniqueItems": True}


@dataclass(frozen=True)
class Part(Note):
    """A part with fields of its own."""


@dataclass(frozen=True)
class Entries(Note):
    """A list of parts, `fewest` to `most` of them."""

    _: KW_ONLY
    fewest: int = 0
    most: int = 0

    def core(self, kind: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        items = handler.generate_schema(get_args(kind)[0])
        schema = core_schema.tuple_variable_schema(items)
        return core_schema.no_info_before_validator_function(self._counted, schema)

    @property
    def _more(self) -> dict[str, Any]:
        return super()._more | {"minItems": self.fewest, "maxItems": self.most}

    def _counted(self, value: Any) -> Any:
        if not is_row(value):
            raise refusal("must be a list")
        if not self.fewest <= len(value) <= self.most:
            raise refusal(f"must have between {self.fewest} and {self.most} entries")
        return value
