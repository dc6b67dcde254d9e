"""The map of a dock's funnel as a picture: which offsets and angles it takes up, and with what force."""

from typing import Any

import numpy as np

from bumpless.campaign.page.plots import LIGHT, figure_of, svg_of
from bumpless.config.mission import Mission
from bumpless.config.vehicle import Vehicle
from bumpless.sim.capture_map import CaptureMap, capture_map

OFFSETS, ANGLES = 11, 13
WIDEST_DEG = 45.0


def capture_pictures(setups: Any) -> list[tuple[str, str]]:
    """(name of the mission, SVG) of each mission with a dock to enter."""
    return [
        (setup.mission.name, picture_of(mapped(setup.mission, setup.vehicle)))
        for setup in setups
        if setup.mission.target.dock is not None
    ]


def mapped(mission: Mission, vehicle: Vehicle) -> CaptureMap:
    """From the axis to a little beyond the entry, to 45 deg on either side."""
    dock = mission.target.dock
    widest = 1.2 * dock.entry_radius_m if dock else 0.0
    offsets, angles = np.linspace(0.0, widest, OFFSETS), np.linspace(-WIDEST_DEG, WIDEST_DEG, ANGLES)
    return capture_map(mission, vehicle, offsets.tolist(), angles.tolist())


def picture_of(found: CaptureMap) -> str:
    """The map as an SVG element: largest force where the hull is captured, grey where it is not."""
    force = np.ma.masked_where(~found.captured, found.force_max_n)
    figure, (axes,) = figure_of(5.4, 3.4)
    figure.subplots_adjust(left=0.12, right=0.98, bottom=0.15)  # axes with labels
    axes.set_facecolor(LIGHT)
    mesh = axes.pcolormesh(
        found.angle_deg, found.offset_m, force, cmap="viridis", shading="nearest", vmin=0.0
    )
    axes.set_xlabel("angle of the hull from the axis, outwards positive, deg")
    axes.set_ylabel("offset of the nose at the entry, m")
    figure.colorbar(mesh, ax=axes, label="largest force, N")
    return svg_of(figure, "Capture over offset and angle: largest force; grey where the hull is not captured")
