"""All that is not on board: the true vehicle in its water, its sensors, and what is true besides."""

import numpy as np

from bumpless.physics.model_record import MODEL
from bumpless.physics.plant import PLANT
from bumpless.physics.sensors import MEASUREMENT, SENSORS
from bumpless.physics.water import water_velocity
from bumpless.sim.truth import TRUTH

WORLD = np.dtype(
    [
        ("truth", TRUTH),
        ("model", MODEL),  # of the true vehicle
        ("sensors", SENSORS),
        ("plant", PLANT),
        ("measurement", MEASUREMENT),  # what the autopilot hears
    ],
    align=True,
)


def clear(record: np.void) -> None:
    """Set every number of a record to zero."""
    for name in record.dtype.names or ():
        record[name] = np.zeros((), record.dtype[name])


def place_plant(truth: np.void, sensors: np.void, plant: np.void, rng: np.random.Generator) -> None:
    """Put the plant at the mission's start; add the sensors' biases, drawn once a run, to the truth."""
    clear(plant)
    plant["eta"] = truth["start"]
    psi, environment = plant["eta"][5], truth["environment"]
    current = environment["current"]
    if environment["n_profile"] or environment["shelter_width"]:
        current = np.zeros(3)
        calm = environment.copy()
        calm["wave_height"] = 0.0
        water_velocity(calm, plant["gust"], 0.0, plant["eta"], current, np.zeros(3))
    plant["nu"][0] = truth["start_speed"] + current[0] * np.cos(psi) + current[1] * np.sin(psi)
    plant["nu"][1] = -current[0] * np.sin(psi) + current[1] * np.cos(psi)
    plant["effectiveness"] = 1.0
    draws = rng.standard_normal(4)
    truth["errors"]["heading_bias"] += draws[0] * sensors["heading_bias_std"]
    truth["errors"]["depth_bias"] += draws[1] * sensors["depth_bias_std"]
    plant["gust"][:2] = draws[2:4] * environment["gust_std"]
    draw_more(truth["errors"], sensors, plant, rng.spawn(1)[0])


def draw_more(errors: np.void, sensors: np.void, plant: np.void, rng: np.random.Generator) -> None:
    """Draw what came later than the first four numbers, from a stream beside: it shifts no other."""
    draws = rng.standard_normal(9)
    errors["roll_pitch_bias"] = draws[:2] * sensors["roll_pitch_bias_std"]
    errors["dvl_scale"] = draws[2] * sensors["dvl_scale_std"]
    errors["dvl_water_bias"] = draws[3:6] * sensors["dvl_water_bias_std"]
    plant["gust"][3:] = draws[6:]
    errors["key"] = rng.integers(2**63)


def start_shafts(model: np.void, truth: np.void, plant: np.void) -> None:
    """Let the screws that push ahead turn as the start speed asks for, by the nominal MODEL.

    T_nn n^2 - T_nv n V = D(V) / (number of screws), solved for n, rev/s: a vehicle that begins at speed does
    not begin with stopped screws.
    """
    V = float(truth["start_speed"])
    drag = float((model["D_linear"][0, 0] + model["D_quadratic"][0, 0] * V) * V)
    ahead = [
        i for i in range(int(model["n_u"])) if model["T_nn"][i] > 0.0 and model["direction"][i, 0] > 0.9
    ]  # fmt: skip
    if drag <= 0.0:
        return
    for i in ahead:
        T_nn, T_nv = float(model["T_nn"][i]), float(model["T_nv"][i]) * V
        n = (T_nv + np.sqrt(T_nv**2 + 4.0 * T_nn * drag / len(ahead))) / (2.0 * T_nn)
        plant["u"][i] = min(n, float(model["command_max"][i]))
