"""How far a vehicle may be off before somebody is told: defaults, and a file for each vehicle.

`limits/<vehicle>.toml` in the data folder may set any of them; what it does not set keeps its default.
"""

import logging
import tomllib
from pathlib import Path

from pydantic import BaseModel, ConfigDict, Field, ValidationError

log = logging.getLogger(__name__)


class Limits(BaseModel):
    """Limits of what is watched. An error counts once it has lasted `for_s`."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    depth_m: float = Field(0.3, gt=0.0)
    heading_deg: float = Field(12.0, gt=0.0)
    cross_track_m: float = Field(1.5, gt=0.0)
    speed_mps: float = Field(0.25, gt=0.0)
    for_s: float = Field(10.0, ge=0.0)  # how long an error must last
    after_switch_s: float = Field(8.0, ge=0.0)  # after a switch a vehicle may be off for so long
    saturated_s: float = Field(5.0, ge=0.0)  # an actuator at its bound for so long
    clock_s: float = Field(60.0, gt=0.0)  # between the vehicle's clock and the server's


def read_limits(path: Path) -> Limits:
    """The limits of a file. One that cannot be read is told in the log and leaves the defaults."""
    try:
        return Limits.model_validate(tomllib.loads(path.read_text(encoding="utf-8")))
    except FileNotFoundError:
        return Limits()
    except (OSError, tomllib.TOMLDecodeError, ValidationError, UnicodeDecodeError) as error:
        log.warning("%s: %s; the default limits hold", path, error)
        return Limits()
