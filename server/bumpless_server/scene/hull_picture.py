"""The vehicle as one small mesh for the 3-D view of reports and replays."""

from typing import Any

from bumpless_server.scene.mesh import merge, moved
from bumpless_server.scene.model import parts_of

SEGMENTS = 10


def hull_picture(vehicle: Any) -> dict[str, Any]:
    """Vertices in body axes, m, to the millimetre, and faces; all joints at zero."""
    parts = parts_of(vehicle, SEGMENTS)
    vertices, faces = merge(*(moved(part.mesh, offset=part.position) for part in parts))
    return {"vertices": vertices.round(3).astype(float).round(3).tolist(), "faces": faces.tolist()}
