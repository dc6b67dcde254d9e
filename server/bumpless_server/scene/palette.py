"""Colours of the scene, the console's own: mid tones that read on a dark and on a light background."""

from bumpless.contract import bumpless_pb2 as pb

Rgb = tuple[int, int, int]

FORWARD: Rgb = (59, 130, 246)  # #3b82f6
REVERSE: Rgb = (245, 158, 11)  # #f59e0b
HOVER: Rgb = (16, 185, 129)  # #10b981
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
CURRENT: Rgb = (20, 184, 166)
GRID_CELL: Rgb = (76, 94, 116)
GRID_SECTION: Rgb = (92, 114, 140)
AXIS_NORTH: Rgb = (220, 68, 68)
AXIS_EAST: Rgb = (46, 160, 90)
AXIS_DOWN: Rgb = (70, 120, 230)

MODE_COLOUR: dict[int, Rgb] = {
    pb.MODE_FORWARD: FORWARD,
    pb.MODE_REVERSE: REVERSE,
    pb.MODE_HOVER: HOVER,
}
MODE_NAME: dict[int, str] = {
    pb.MODE_FORWARD: "F · Forward",
    pb.MODE_REVERSE: "R · Reverse",
    pb.MODE_HOVER: "H · Hover",
}


def vertex_colour(rgb: Rgb) -> Rgb:
    """A colour as viser wants it per vertex of a line: linear, where single colours are sRGB."""
    red, green, blue = (round(255.0 * (c / 255.0) ** 2.2) for c in rgb)
    return red, green, blue


def mode_colour(mode: int) -> Rgb:
    """Colour of a contract Mode; grey when unspecified."""
    return MODE_COLOUR.get(mode, IDLE)
