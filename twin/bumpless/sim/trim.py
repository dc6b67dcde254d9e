"""Weights that nobody on board knows of, put into the true vehicle."""

import numpy as np

from bumpless.config.mission.trim import Trim
from bumpless.physics.model import skew


def load(model: np.void, trim: Trim | None) -> None:
    """Change mass, inertia, centre of gravity and buoyancy of a MODEL record as a mission's `trim` has them.

    Source: Fossen 2021, eq. (3.49): M_RB about O_b is a sum over masses, so that a point mass m at r adds
    m [[I, -S(r)], [S(r), -S(r)^2]].
    """
    if trim is None:
        return
    mass = float(model["M_RB"][0, 0])
    gravity, moment = float(model["weight"]) / mass, mass * model["r_g"]
    for weight in trim.weights:
        for place, sign in ((weight.from_m, -1.0), (weight.to_m, 1.0)):
            if place is not None:
                m, S = sign * weight.mass_kg, skew(place)
                mass, moment = mass + m, moment + m * np.array(place)
                model["M_RB"] += m * np.block([[np.eye(3), -S], [S, -S @ S]])
    model["weight"], model["r_g"] = mass * gravity, moment / mass
    model["buoyancy"] += trim.buoyancy_n
    model["M_inv"] = np.linalg.inv(model["M_RB"] + model["M_A"])
