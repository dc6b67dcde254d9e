"""A vehicle is a file: load one, or say exactly what is wrong with it."""

from bumpless.config.names import WRENCH
from bumpless.config.vehicle.load import (
    FOLDER,
    VehicleError,
    load_vehicle,
    parse_vehicle,
    vehicle_names,
)
from bumpless.config.vehicle.model import Vehicle
from bumpless.config.vehicle.parts import Actuator, Command, Fin, MyringHull, TabulatedHull, Thruster

__all__ = [
    "FOLDER",
    "WRENCH",
    "Actuator",
    "Command",
    "Fin",
    "MyringHull",
    "TabulatedHull",
    "Thruster",
    "Vehicle",
    "VehicleError",
    "load_vehicle",
    "parse_vehicle",
    "vehicle_names",
]
