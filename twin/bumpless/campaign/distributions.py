"""How one quantity is distributed: `{uniform: [a, b]}`, `{loguniform: [a, b]}`, `{normal: [mean, std]}`,
`{choice: [...]}`, or one value for all.

Each turns a share between 0 and 1 into a value, so a draw is one number from its own random stream.
"""

from dataclasses import KW_ONLY, dataclass
from statistics import NormalDist
from typing import Annotated, Any

from pydantic import GetCoreSchemaHandler
from pydantic_core import CoreSchema, core_schema

from bumpless.config.declare import Entries, Row, model
from bumpless.config.declare.notes import in_words, refusal

Pair = tuple[float, float]
Value = float | str
ENDS = ("from", "to")


@dataclass(frozen=True)
class Ends(Row):
    """Two ends, the first not above the second, and both above `above` where that is given."""

    _: KW_ONLY
    above: float | None = None

    def core(self, kind: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """The row, then its order."""
        return core_schema.no_info_after_validator_function(self._in_order, super().core(kind, handler))

    def _in_order(self, ends: Pair) -> Pair:
        if ends[0] > ends[1]:
            raise refusal("the first end must not lie above the second")
        if self.above is not None and ends[0] <= self.above:
            raise refusal(f"both ends must be > {self.above:g}")
        return ends


@dataclass(frozen=True)
class Spread(Row):
    """A mean and a standard deviation."""

    def core(self, kind: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """The row, then its sign."""
        return core_schema.no_info_after_validator_function(self._positive, super().core(kind, handler))

    def _positive(self, pair: Pair) -> Pair:
        if pair[1] < 0.0:
            raise refusal("the deviation must be >= 0")
        return pair


@dataclass(frozen=True)
class Values(Entries):
    """A list of numbers or texts."""

    def core(self, kind: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """A row of numbers and texts, of the right length."""
        number = core_schema.float_schema(strict=True, allow_inf_nan=False)
        one = core_schema.union_schema([number, core_schema.str_schema(strict=True)])
        items = in_words(one, lambda _: "must be a number or a name")
        rows = core_schema.tuple_variable_schema(items)
        return core_schema.no_info_before_validator_function(self._counted, rows)


@model
class Uniform:
    """Every number between two ends alike."""

    uniform: Annotated[Pair, Ends("Every number between two ends alike", names=ENDS)]

    def at(self, share: float) -> float:
        """The value below which this share of all lies."""
        low, high = self.uniform
        return low + (high - low) * share

    @property
    def ends(self) -> tuple[Value, ...]:
        """Values that bound all others; every one for a choice."""
        return self.uniform


@model
class LogUniform:
    """Every factor between two ends alike."""

    loguniform: Annotated[Pair, Ends("Every factor between two ends alike", names=ENDS, above=0.0)]

    def at(self, share: float) -> float:
        """As for Uniform."""
        low, high = self.loguniform
        return float(low * (high / low) ** share)

    @property
    def ends(self) -> tuple[Value, ...]:
        """As for Uniform."""
        return self.loguniform


@model
class Normal:
    """Normal about a mean, cut at three standard deviations so that its ends can be checked."""

    normal: Annotated[
        Pair, Spread("Normal about a mean, cut at three deviations", names=("mean", "deviation"))
    ]

    def at(self, share: float) -> float:
        """As for Uniform."""
        mean, std = self.normal
        inner = NormalDist()
        low = inner.cdf(-3.0)
        return mean + std * inner.inv_cdf(low + (1.0 - 2.0 * low) * share)

    @property
    def ends(self) -> tuple[Value, ...]:
        """As for Uniform."""
        mean, std = self.normal
        return mean - 3.0 * std, mean + 3.0 * std


@model
class Choice:
    """One of several values, each alike."""

    choice: Annotated[tuple[Value, ...], Values("One of these, each alike", fewest=1, most=1000)]

    def at(self, share: float) -> Value:
        """As for Uniform."""
        return self.choice[min(int(share * len(self.choice)), len(self.choice) - 1)]

    @property
    def ends(self) -> tuple[Value, ...]:
        """As for Uniform."""
        return self.choice


Distribution = Uniform | LogUniform | Normal | Choice
KINDS: dict[str, type[Any]] = {
    "uniform": Uniform,
    "loguniform": LogUniform,
    "normal": Normal,
    "choice": Choice,
}
