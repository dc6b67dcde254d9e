"""How the flight modes are named, lettered and coloured, wherever they are shown."""

from dataclasses import dataclass

from bumpless.contract.enums import FORWARD, HOVER, REVERSE


@dataclass(frozen=True)
class ModeLook:
    """One mode for people. Colour never stands alone: the letter goes with it."""

    mode: int  # Mode of the contract
    key: str  # in code, parameters and style sheets
    letter: str
    name: str
    colour: str  # sRGB, "#rrggbb": a mid tone that reads on a dark and on a light ground


MODES = (
    ModeLook(FORWARD, "forward", "F", "Forward", "#3b82f6"),
    ModeLook(REVERSE, "reverse", "R", "Reverse", "#f59e0b"),
    ModeLook(HOVER, "hover", "H", "Hover", "#10b981"),
)
LOOKS: dict[int, ModeLook] = {look.mode: look for look in MODES}
MODE_LETTERS = {look.mode: look.letter for look in MODES}
