"""Colours of the scene, the console's own: mid tones that read on a dark and on a light background."""

from bumpless.contract.modes import MODES

Rgb = tuple[int, int, int]


def _rgb(colour: str) -> Rgb:
    """The parts of "#rrggbb"."""
    red, green, blue = bytes.fromhex(colour[1:])
    return red, green, blue


def css(rgb: Rgb) -> str:
    """A colour as style sheets write it, "#rrggbb"."""
    return "#" + bytes(rgb).hex()


MODE_COLOUR: dict[int, Rgb] = {look.mode: _rgb(look.colour) for look in MODES}
FORWARD, REVERSE, HOVER = (_rgb(look.colour) for look in MODES)
IDLE: Rgb = (148, 163, 184)
STALE: Rgb = (120, 124, 130)

HULL: Rgb = (226, 232, 240)
FRAME: Rgb = (120, 134, 156)
FIN: Rgb = (148, 160, 178)
PROPELLER: Rgb = (180, 140, 80)

DEMANDED: Rgb = (217, 70, 239)  # tau_d
ACHIEVED: Rgb = (6, 182, 212)  # tau_c
RESIDUAL: Rgb = (239, 68, 68)  # tau_d - tau_c
FORCE_SET: Rgb = (56, 189, 248)
MOMENT_SET: Rgb = (129, 140, 248)

TARGET: Rgb = (250, 204, 21)
PATH: Rgb = (148, 163, 184)
GHOST: Rgb = (245, 158, 11)  # of a flight ahead with a draft
RULER: Rgb = (244, 114, 182)
CURRENT: Rgb = (20, 184, 166)
HOLDS: Rgb = (16, 185, 129)  # headings that hold station, that may not, that can't
MAY_NOT_HOLD: Rgb = (234, 160, 20)
CANT_HOLD: Rgb = (208, 88, 88)
GRID_CELL: Rgb = (76, 94, 116)
GRID_SECTION: Rgb = (92, 114, 140)
AXIS_NORTH: Rgb = (220, 68, 68)
AXIS_EAST: Rgb = (46, 160, 90)
AXIS_DOWN: Rgb = (70, 120, 230)

# What the page's legend explains, in this order.
LEGEND: tuple[tuple[Rgb, str], ...] = (
    (DEMANDED, "τ_d demanded"),
    (ACHIEVED, "τ_c achieved"),
    (RESIDUAL, "residual"),
    *((_rgb(look.colour), f"{look.letter} {look.name.lower()}") for look in MODES),
    (PATH, "planned path"),
)


def vertex_colour(rgb: Rgb) -> Rgb:
    """A colour as viser wants it per vertex of a line: linear, where single colours are sRGB."""
    red, green, blue = (round(255.0 * (c / 255.0) ** 2.2) for c in rgb)
    return red, green, blue


def mode_colour(mode: int) -> Rgb:
    """Colour of a contract Mode; grey when unspecified."""
    return MODE_COLOUR.get(mode, IDLE)
