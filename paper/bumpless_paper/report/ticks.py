"""Round numbers along an axis, and numbers as people write them."""

import math


def ticks(low: float, high: float, count: int = 6) -> list[float]:
    """About `count` round values within [low, high]."""
    span = high - low
    if not math.isfinite(span) or span <= 0.0:
        return [low]
    step = 10.0 ** math.floor(math.log10(span / count))
    step *= min((m for m in (1.0, 2.0, 5.0, 10.0) if span / (m * step) <= count), default=10.0)
    first = math.ceil(low / step - 1e-9)
    last = math.floor(high / step + 1e-9)
    return [k * step for k in range(first, last + 1)]


def decades(low: float, high: float) -> list[float]:
    """Powers of ten within [low, high]; with 2 and 5 times them where the range holds fewer than three."""
    first, last = math.floor(math.log10(low)), math.ceil(math.log10(high))
    within = [
        m * 10.0**k
        for k in range(first, last + 1)
        for m in (1.0, 2.0, 5.0)
        if low * (1 - 1e-9) <= m * 10.0**k <= high * (1 + 1e-9)
    ]
    powers = [value for value in within if abs(math.log10(value) % 1.0) < 1e-9]
    return powers if len(powers) >= 3 else within


def number(value: object, digits: int = 4) -> str:
    """A value for a table: four significant digits, a dash when there is none."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int):
        return f"{value:,}".replace(",", " ") if abs(value) >= 10_000 else str(value)
    if isinstance(value, float):
        if not math.isfinite(value):
            return "–"
        if 1e4 <= abs(value) < 1e7:
            return f"{value:,.0f}".replace(",", " ").replace("-", "−")
        return f"{value:.{digits}g}".replace("-", "−")
    return str(value)


def percent(value: float | None) -> str:
    """A share as a signed percentage."""
    if value is None:
        return ""
    shown = value * 100.0
    if abs(shown) >= 10_000:
        return "> +9999 %" if shown > 0 else "< −9999 %"
    text = f"{shown:+.1f}" if abs(shown) < 100 else f"{shown:+.0f}"
    return f"{text} %".replace("-", "−")


def share(value: float | None, digits: int = 0) -> str:
    """A share as a percentage."""
    return "–" if value is None else f"{value:.{digits}%}".replace("%", " %").replace("-", "−")


def change(ratio: float | None) -> str:
    """A ratio of two figures as the change from the second to the first."""
    return "–" if ratio is None else percent(ratio - 1.0)


def words(name: str) -> str:
    """A goal's name as people write it."""
    return name.replace("->", "→").replace("<=", " ≤ ").replace("e_tau", "e_τ")
