"""What a planner draws about a mission's vehicle."""

from bumpless.config.parameters import default_parameters
from bumpless.config.vehicle import Vehicle
from bumpless_server.web.answers.contract import Answer


class Sight(Answer):
    """The target camera's, as the vehicle file says; a mission may set others."""

    range_min_m: float
    range_max_m: float
    half_angle_deg: float


class Approach(Answer):
    """How the vehicle docks by itself, by its own parameters. Distances are from the observation point."""

    enabled: bool
    entry_distance_m: float
    keep_out_m: float  # from the target
    break_off_m: float
    cone_base_m: float
    cone_slope: float


class Planning(Answer):
    """A vehicle as a plan shows it: size, sight, thresholds and approach, and what can fail."""

    id: str
    name: str
    sha256: str
    length_m: float
    diameter_m: float
    sways: bool
    sight: Sight
    thresholds_m: dict[str, float]  # the supervisor's ranges, by parameter
    approach: Approach
    actuators: list[str]

    @classmethod
    def of(cls, vehicle: Vehicle) -> "Planning":
        """By the vehicle's file and its own parameters."""
        parameters, camera = default_parameters(vehicle), vehicle.sensors.camera
        docking, supervisor = parameters.docking, parameters.supervisor
        ranges = ("range_rh_lower_m", "range_rh_upper_m", "range_fr_lower_m", "range_fr_upper_m")
        return cls(
            id=vehicle.id,
            name=vehicle.name,
            sha256=vehicle.sha256,
            length_m=vehicle.hull.length_m,
            diameter_m=vehicle.hull.diameter_m,
            sways="Y" in vehicle.controllable,
            sight=Sight(
                range_min_m=camera.range_min_m,
                range_max_m=camera.range_max_m,
                half_angle_deg=camera.field_of_view_half_deg,
            ),
            thresholds_m={name: getattr(supervisor, name) for name in ranges},
            approach=Approach.model_validate(docking, from_attributes=True),
            actuators=[actuator.name for actuator in vehicle.actuators],
        )
