"""The parts of the report, in the order of the page. Each is `part(progress) -> Part`.

progress: called with the share done, 0 to 1.
"""

from collections.abc import Callable
from importlib import import_module

from bumpless_paper.report.content import Part

Progress = Callable[[float], None]

# name of `--only` -> module here and its function
PARTS: dict[str, tuple[str, str]] = {
    "outcome": ("outcome", "part"),
    "fair": ("fair", "part"),
    "table3": ("envelopes", "part"),
    "identify": ("identify", "part"),
    "remus": ("remus", "part"),
    "physics": ("physics", "part"),
    "vehicles": ("vehicles", "part"),
    "table6": ("study", "table6_part"),
    "table7": ("study", "table7_part"),
    "table8": ("study", "table8_part"),
    "honest": ("honest", "part"),
    "diagnosis": ("diagnosis", "part"),
    "robustness": ("robustness", "part"),
    "extensions": ("extensions", "part"),
    "tradeoff": ("tradeoff", "part"),
    "tank": ("tank", "part"),
    "stability": ("stability", "part"),
}

# tables and figures by their names -> the part that makes them
ALIASES: dict[str, str] = {"envelopes": "table3", "tableA5": "tank", "tableA6": "tank"}


def wanted_parts(only: list[str]) -> list[str]:
    """Parts to make, in the order of the page; all for an empty list. KeyError names what is unknown."""
    chosen = []
    for name in only:
        part = ALIASES.get(name, name)
        if part not in PARTS:
            raise KeyError(name)
        chosen.append(part)
    return [name for name in PARTS if not only or name in chosen]


def run_part(name: str, progress: Progress = lambda _: None) -> Part:
    """Make one part; its modules are imported only now."""
    module, function = PARTS[name]
    return getattr(import_module(f"bumpless_paper.report.parts.{module}"), function)(progress)
