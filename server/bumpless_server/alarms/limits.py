"""How far a vehicle may be off before somebody is told: defaults, and a file for each vehicle.

`limits/<vehicle>.toml` in the data folder may set any of them; what it does not set keeps its default.
"""

import logging
import tomllib
from pathlib import Path
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field, ValidationError

log = logging.getLogger(__name__)


class Limits(BaseModel):
    """Limits of what is watched. An error counts once it has lasted `for_s`."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    depth_m: Annotated[float, Field(gt=0.0)] = 0.3
    heading_deg: Annotated[float, Field(gt=0.0)] = 12.0
    cross_track_m: Annotated[float, Field(gt=0.0)] = 1.5
    speed_mps: Annotated[float, Field(gt=0.0)] = 0.25
    for_s: Annotated[float, Field(ge=0.0)] = 10.0  # how long an error must last
    after_switch_s: Annotated[float, Field(ge=0.0)] = 8.0  # after a switch a vehicle may be off for so long
    saturated_s: Annotated[float, Field(ge=0.0)] = 5.0  # an actuator at its bound for so long
    deepest_m: Annotated[float | None, Field(gt=0.0)] = None  # depth that is never to be passed
    area_m: Annotated[float | None, Field(gt=0.0)] = None  # farthest from the mission's start, horizontally
    disk_mb: Annotated[float, Field(ge=0.0)] = 2000.0  # free on the disk of the runs
    clock_s: Annotated[float, Field(gt=0.0)] = 60.0  # between the vehicle's clock and the server's


def read_limits(path: Path) -> Limits:
    """The limits of a file. One that cannot be read is told in the log and leaves the defaults."""
    try:
        return Limits.model_validate(tomllib.loads(path.read_text(encoding="utf-8")))
    except FileNotFoundError:
        return Limits()
    except (OSError, tomllib.TOMLDecodeError, ValidationError, UnicodeDecodeError) as error:
        log.warning("%s: %s; the default limits hold", path, error)
        return Limits()
