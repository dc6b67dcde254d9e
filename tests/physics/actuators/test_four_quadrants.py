"""The plant's screw beside four-quadrant curves that were measured, not by us."""

from dataclasses import replace

import numpy as np
import pytest

from bumpless.config.vehicle import Thruster, load_vehicle
from bumpless_paper.screws.__main__ import main
from bumpless_paper.screws.curve import NAMES, measured, numbers_of, of_the_plant

BETA = np.radians(np.arange(0.0, 360.0, 5.0))


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("slope", [0.0, 0.3])
def test_signs_and_zeros_are_those_measured(name: str, slope: float):
    """Protects: thrust has the measured sign in all four quadrants, but close to its two zeros."""
    curve, form = measured(name, BETA)[0], of_the_plant(numbers_of(name, slope), BETA)
    clear = np.abs(curve) > 0.06
    assert clear.sum() > 60
    assert (np.sign(form) == np.sign(curve))[clear].all()


@pytest.mark.parametrize(("name", "slope", "share"), [("B4-70", 0.0, 0.10), ("B4-40", 0.3, 0.11)])
def test_form_follows_the_curve(name: str, slope: float, share: float):
    """Protects: with bollard thrust, zero thrust, stopped drag and one slope of the screw, what lies between
    follows: RMS over all quadrants in parts of the curve's amplitude."""
    curve, form = measured(name, BETA)[0], of_the_plant(numbers_of(name, slope), BETA)
    assert np.sqrt(np.mean((form - curve) ** 2)) < share * np.abs(curve).max()


def test_without_a_slope_crash_back_is_on_the_weak_side():
    """Protects: what is said of TS-100, as strong astern as ahead and without slope: slow astern in fast flow
    it brakes up to 0.45 less than a screw of its blade area; full astern, from 160 deg on, no less."""
    even = numbers_of("B4-40")
    even = replace(even, bollard_astern=even.bollard)
    beta = np.radians(np.arange(110.0, 171.0, 5.0))
    share = of_the_plant(even, beta) / measured("B4-40", beta)[0]
    assert 0.55 < share.min() < 0.6 and np.degrees(beta[np.argmin(share)]) == pytest.approx(130.0, abs=6.0)
    assert (share[np.degrees(beta) > 159.0] > 1.0).all()


def test_ts100s_stopped_screw_is_one_of_its_blade_area():
    """Protects: the assumed 0.4 and 0.05, for blades over 0.4 of the disc, are those of B4-40."""
    screw = next(a for a in load_vehicle("ts100").actuators if a.name == "n_p")
    assert isinstance(screw, Thruster) and screw.flow
    found = numbers_of("B4-40")
    astern = measured("B4-40", np.radians([270.0]))
    assert screw.flow.stopped_drag_coefficient == pytest.approx(
        (found.stopped_drag + astern[0][0]) / 2, rel=0.06
    )
    assert screw.flow.stopped_torque_coefficient == pytest.approx(
        (found.stopped_torque + astern[1][0]) / 2, rel=0.06
    )


def test_table_is_printed(capsys: pytest.CaptureFixture[str]):
    """Protects: the figures of docs/plant.md come from a command."""
    main()
    assert "B4-40: bollard 0.202 ahead" in capsys.readouterr().out
