"""How one quantity is distributed: `{uniform: [a, b]}`, `{loguniform: [a, b]}`, `{normal: [mean, std]}`,
`{choice: [...]}`, or one value for all.

Each turns a share between 0 and 1 into a value, so a draw is one number from its own random stream.
"""

from statistics import NormalDist
from typing import Annotated, TypeVar

from pydantic import BaseModel, ConfigDict, Field, FiniteFloat, model_validator

Pair = tuple[FiniteFloat, FiniteFloat]
Value = float | str
D = TypeVar("D")


class _Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)


class Uniform(_Strict):
    """Every number between two ends alike."""

    uniform: Pair

    @model_validator(mode="after")
    def _in_order(self) -> "Uniform":
        return _ordered(self, self.uniform)

    def at(self, share: float) -> float:
        """The value below which this share of all lies."""
        low, high = self.uniform
        return low + (high - low) * share

    @property
    def ends(self) -> tuple[Value, ...]:
        """Values that bound all others; every one for a choice."""
        return self.uniform


class LogUniform(_Strict):
    """Every factor between two ends alike."""

    loguniform: tuple[Annotated[FiniteFloat, Field(gt=0)], Annotated[FiniteFloat, Field(gt=0)]]

    @model_validator(mode="after")
    def _in_order(self) -> "LogUniform":
        return _ordered(self, self.loguniform)

    def at(self, share: float) -> float:
        """As for Uniform."""
        low, high = self.loguniform
        return float(low * (high / low) ** share)

    @property
    def ends(self) -> tuple[Value, ...]:
        """As for Uniform."""
        return self.loguniform


class Normal(_Strict):
    """Normal about a mean, cut at three standard deviations so that its ends can be checked."""

    normal: tuple[FiniteFloat, Annotated[FiniteFloat, Field(ge=0)]]

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


class Choice(_Strict):
    """One of several values, each alike."""

    choice: Annotated[tuple[FiniteFloat | str, ...], Field(min_length=1)]

    def at(self, share: float) -> Value:
        """As for Uniform."""
        return self.choice[min(int(share * len(self.choice)), len(self.choice) - 1)]

    @property
    def ends(self) -> tuple[Value, ...]:
        """As for Uniform."""
        return self.choice


Distribution = Uniform | LogUniform | Normal | Choice
KINDS: dict[str, type[_Strict]] = {
    "uniform": Uniform,
    "loguniform": LogUniform,
    "normal": Normal,
    "choice": Choice,
}


def _ordered(distribution: D, ends: Pair) -> D:
    if ends[0] > ends[1]:
        raise ValueError(f"the first end must not lie above the second: {list(ends)}")
    return distribution
