"""Draws by number."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import kstest

from bumpless.campaign.distributions import Choice, LogUniform, Normal, Uniform
from bumpless.campaign.drawn import drawn_mission, relative_current
from bumpless.campaign.draws import draw, even_draw, flight_seed, share
from bumpless.campaign.even import even_shares
from bumpless.campaign.mission_text import mission_text
from bumpless.campaign.prepared import Prepared
from bumpless.campaign.quantities import QUANTITIES
from bumpless.config.mission import parse_mission, shipped_mission

TABLE = {"lag": LogUniform(loguniform=(0.5, 2.0)), "mass": Uniform(uniform=(0.9, 1.1))}


def test_a_draw_is_always_the_same():
    """Protects: published results can be flown again; another hash or stream would change all."""
    assert share(1, 2, "lag") == 0.7467762947954667
    assert flight_seed(1, 2) == 108069693


def test_a_draw_depends_on_nothing_else():
    """Protects: a quantity added, or another order, leaves the other quantities as they were."""
    both, one = draw(TABLE, 3, 11), draw({"mass": TABLE["mass"]}, 3, 11)
    assert both["mass"] == one["mass"]
    assert draw(dict(reversed(TABLE.items())), 3, 11) == both


def test_streams_are_independent():
    """Protects: shares are uniform, and neither quantities nor neighbouring numbers move together."""
    shares = np.array([[share(5, n, name) for name in ("lag", "mass")] for n in range(4000)])
    assert kstest(shares[:, 0], "uniform").pvalue > 0.01
    assert abs(np.corrcoef(shares.T)[0, 1]) < 0.05
    assert abs(np.corrcoef(shares[:-1, 0], shares[1:, 0])[0, 1]) < 0.05
    assert len({flight_seed(5, n) for n in range(4000)}) == 4000


def test_even_shares_fill_the_space_and_are_always_the_same():
    """Protects: a fan is the same whenever it is flown, and any part of it leaves no corner out."""
    points = np.array([even_shares(9, n, 3) for n in range(2048)])
    assert even_shares(9, 1500, 3).tolist() == points[1500].tolist()
    assert not np.allclose(points[:100], [even_shares(10, n, 3) for n in range(100)])
    for part in (points[:64], points[64:192], points[1000:1256]):
        bins, _ = np.histogram(part[:, 1], 8, (0.0, 1.0))
        assert bins.min() > 0.7 * len(part) / 8  # at random a bin holds 8 +- 2.6 of 64
    assert ((points >= 0.0) & (points < 1.0)).all()
    assert abs(np.asarray(np.corrcoef(points.T))[0, 2]) < 0.05


def test_even_draws_are_of_the_same_distributions():
    """Protects: an even fan tells the chance of the same sea and the same vehicle, only better."""
    table = {"mass": Uniform(uniform=(0.9, 1.1)), "lag": LogUniform(loguniform=(0.5, 2.0))}
    mass = np.array([even_draw(table, 4, n)["mass"] for n in range(256)], float)
    assert abs(mass.mean() - 1.0) < 0.001 and 0.9 <= mass.min() < 0.902 and 1.098 < mass.max() <= 1.1
    assert even_draw(dict(reversed(table.items())), 4, 7) == even_draw(table, 4, 7)
    assert even_draw({}, 4, 7) == {}


def test_distributions_follow_their_names():
    """Protects: ends, medians and spread of each distribution."""
    shares = (np.arange(4000) + 0.5) / 4000
    normal = np.array([Normal(normal=(2.0, 0.5)).at(float(x)) for x in shares])
    assert normal.mean() == pytest.approx(2.0, abs=1e-6)
    assert normal.std() == pytest.approx(0.5, rel=0.03)
    assert (np.abs(normal - 2.0) <= 1.5 + 1e-9).all()
    assert LogUniform(loguniform=(0.5, 2.0)).at(0.5) == pytest.approx(1.0)
    assert Uniform(uniform=(-1.0, 3.0)).at(0.25) == 0.0
    assert [Choice(choice=(1.0, 2.0, 4.0)).at(x) for x in (0.0, 0.5, 0.999999)] == [1.0, 2.0, 4.0]


def test_current_is_relative_to_the_approach():
    """Protects: 180 degrees is a head current whatever the approach heading, and the map reads it back."""
    mission = drawn_mission(
        shipped_mission("docking"),
        {"target_turn_deg": 90.0, "current_speed_mps": 0.2, "current_relative_deg": 180.0},
    )
    assert mission.environment.current_ned_mps[:2] == pytest.approx((0.0, -0.2))
    assert relative_current(mission) == pytest.approx((0.2, 180.0))


def test_target_is_moved_in_approach_axes():
    """Protects: `across` is to starboard of the way in."""
    mission = drawn_mission(
        shipped_mission("docking"), {"target_turn_deg": 90.0, "target_along_m": 1.0, "target_across_m": 2.0}
    )
    assert mission.target.true_offset_ned_m == pytest.approx((-2.0, 1.0, 0.0))


def test_harder_sea_and_sensors_are_drawn():
    """Protects: what is drawn of water, sensors and a hung dock reaches the mission's own fields."""
    mission = drawn_mission(
        shipped_mission("docking_funnel"),
        {
            "target_turn_deg": 90.0, "attenuation_per_m": 0.4, "water_depth_m": 30.0, "shelter_width_m": 0.9,
            "shelter_turbulence": 0.2, "dock_heave_m": 0.1, "dock_sway_m": 0.2, "dock_phase_deg": 40.0,
            "detection_latency_s": 0.3, "detection_outliers": 0.01, "marker_angle_deg": 60.0,
            "heading_drift_degprth": 0.2, "roll_pitch_bias_deg": 0.4, "dvl_scale_error": 0.01,
            "dvl_water_bias_mps": 0.02, "dvl_dropout": 0.1, "dvl_outage_at_s": 5.0,
            "dvl_outage_length_s": 7.0,
        },
    )  # fmt: skip
    sea, sensors, motion = mission.environment, mission.sensors, mission.target.motion
    assert (sea.beam_attenuation_per_m, sea.water_depth_m) == (0.4, 30.0)
    assert sea.shelter and (sea.shelter.width_m, sea.shelter.turbulence) == (0.9, 0.2)
    assert motion and motion.amplitude_ned_m == pytest.approx((-0.2, 0.0, 0.1))
    assert (motion.period_s, motion.phase_deg) == (9.0, 40.0)  # the period stays the mission's
    camera, ins, dvl = sensors.detection, sensors.ins, sensors.dvl
    assert camera and (camera.latency_s, camera.outlier_probability) == (0.3, 0.01)
    assert camera.marker_angle_max_deg == 60.0
    assert ins and (ins.heading_drift_degprth, ins.roll_pitch_bias_deg) == (0.2, 0.4)
    assert dvl and (dvl.scale_error, dvl.water_bias_mps, dvl.dropout_probability) == (0.01, 0.02, 0.1)
    assert [(o.from_s, o.to_s) for o in sensors.dvl_outages] == [(5.0, 12.0)]
    assert parse_mission(mission_text(mission), "drawn").target == mission.target
    assert drawn_mission(mission, {}) == mission


def test_start_and_faults_are_drawn():
    """Protects: what is drawn reaches the mission's own fields."""
    mission = drawn_mission(
        shipped_mission("docking"),
        {
            "start_abeam_m": 2.0,
            "start_turn_deg": 10.0,
            "fault_actuator": "n_p",
            "fault_at_s": 20.0,
            "fault_effectiveness": 0.5,
            "outage_at_s": 30.0,
            "outage_length_s": 4.0,
        },
    )
    assert mission.start.position_ned_m == pytest.approx((0.0, 2.0, 2.0))
    assert mission.start.heading_deg == pytest.approx(10.0)
    assert (mission.faults[0].actuator, mission.faults[0].at_s) == ("n_p", 20.0)
    assert (mission.sensors.outages[0].from_s, mission.sensors.outages[0].to_s) == (30.0, 34.0)


@pytest.mark.parametrize("name", ["docking", "docking_current", "s6_fault_tolerant", "tank1"])
def test_mission_text_reads_back(name):
    """Protects: the log of a flight that is flown again carries exactly the mission that was flown."""
    mission = shipped_mission(name)
    again = parse_mission(mission_text(mission), mission.source)
    assert replace(again, text=mission.text) == mission


@pytest.mark.parametrize("title", ["045", "1e5", "yes", "null", "0x1F", "~", "a: b", "S5 – Δ", ""])
def test_titles_that_look_like_numbers_stay_titles(title):
    """Protects: the text of a drawn mission says what was flown, whatever YAML would make of its words."""
    mission = replace(shipped_mission("docking"), title=title)
    assert parse_mission(mission_text(mission), "m.yaml").title == title


def test_every_quantity_changes_a_flight(campaign: Callable[..., Prepared], ts100):
    """Protects: no quantity of the table is without effect."""
    from bumpless.campaign.drawn import drawn_vehicle
    from bumpless.campaign.plant import Alteration

    mission = drawn_mission(
        shipped_mission("docking"),
        {"wave_height_m": 0.1, "fault_actuator": "n_p", "fault_at_s": 9.0, "fault_effectiveness": 0.5},
    )
    for name, quantity in QUANTITIES.items():
        chosen = {"fault_actuator": "n_v1", "actuator_flow": 1.0}
        value = chosen[name] if name in chosen else 1.25 if quantity.factor else max(0.3, quantity.low)
        values = {name: value}
        if name.startswith(("current_speed", "current_relative")):
            values = {"current_speed_mps": 0.1, "current_relative_deg": 10.0} | values
        if name.startswith("dvl_outage"):
            values = {"dvl_outage_at_s": 1.0, "dvl_outage_length_s": 2.0} | values
        if name.startswith(("dock_period", "dock_phase")):
            values = {"dock_heave_m": 0.1} | values
        if name.startswith("outage"):
            values = {"outage_at_s": 1.0, "outage_length_s": 2.0} | values
        if name.startswith("ballast"):
            values = {"ballast_n": 0.1, "ballast_x_m": 0.1} | values
        changed = (drawn_mission(mission, values), drawn_vehicle(ts100, values), Alteration.of(values))
        assert changed != (mission, ts100, Alteration()), name


@pytest.mark.parametrize(
    ("drawn", "flown"), [({}, False), ({"actuator_flow": 1}, True), ({"actuator_flow": 0}, False)]
)
def test_the_real_flow_is_drawn(drawn, flown):
    """Protects: campaigns fly with the real flow or without; undrawn as the mission says."""
    assert drawn_mission(shipped_mission("docking"), drawn).actuator_flow is flown
