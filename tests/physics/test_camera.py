"""The cameras: field of view, near camera, the marker's face, turbid water, latency, false sights."""

import numpy as np
import pytest

from bumpless.physics.camera import CONE, RECTANGLE, place_seen, view_from
from tests.physics.sensing import TARGET, Suite


def seen(suite: Suite) -> bool:
    (m,) = suite.hear()
    return bool(m["detected"])


def test_a_place_seen_is_the_place(model: np.record) -> None:
    """Protects: the camera's axes and their inverse, wherever it sits and looks."""
    eta, place = np.array([1.0, 2.0, 3.0, 0.1, -0.2, 2.5]), np.array([0.9, 0.1, -0.2])
    point, view, back = np.array([4.0, -3.0, 5.0]), np.zeros(3), np.zeros(3)
    view_from(place, 0.4, eta, point, view)
    place_seen(place, 0.4, eta, view, back)
    np.testing.assert_allclose(back, point, atol=1e-12)


@pytest.mark.parametrize(
    ("shape", "at", "expected"),
    [  # 10 m off, half angles 40 deg across and 20 deg up and down: 8.39 m and 3.64 m
        (RECTANGLE, (8.3, 0.0), True), (RECTANGLE, (8.5, 0.0), False),
        (RECTANGLE, (0.0, 3.6), True), (RECTANGLE, (0.0, 3.7), False),
        (RECTANGLE, (8.3, 3.6), True),  # a corner, where the elevation itself is 15.4 deg
        (CONE, (8.3, 0.0), True), (CONE, (0.0, 8.3), True),
        (CONE, (6.2, 6.2), False), (CONE, (5.8, 5.8), True),
    ],
)  # fmt: skip
def test_the_field_of_view_has_its_form(shape: int, at: tuple, expected: bool) -> None:
    """Protects: a rectangle is tan-tan in the image, corners included, and a cone is round."""
    suite = Suite(camera_shape=shape, camera_half_vertical=np.radians(20))
    assert seen(suite.put(0.0, at[0], TARGET[2] + at[1])) is expected


def test_what_is_behind_is_in_no_field_of_view() -> None:
    """Protects: tan() repeats after half a turn; a camera does not."""
    for shape in (RECTANGLE, CONE):
        assert not seen(Suite(camera_shape=shape).put(0.0, heading=180.0))


def test_the_near_camera_takes_over_close_by() -> None:
    """Protects: below the wide camera's nearest range the near one's sight counts, in its own axes, and
    where neither sees there is none."""
    near = np.radians([0.0, 30.0])
    said = {
        "n_cameras": 2,
        "camera_range_min": [1.0, 0.1],
        "camera_range_max": [100.0, 2.0],
        "camera_pitch": near,
    }
    suite = Suite(**said)
    far, close = suite.put(0.0).hear()[0], suite.put(9.3, down=1.7).hear()[0]
    assert (far["detected"], far["camera"], close["detected"], close["camera"]) == (1, 0, 1, 1)
    assert close["target"][2] == pytest.approx(np.arctan2(0.3, 0.7) - near[1])
    assert not seen(Suite(**said | {"n_cameras": 1}).put(9.3, down=1.7))


@pytest.mark.parametrize(
    ("angle", "expected"), [(0, True), (59, True), (61, False), (85, False), (180, False)]
)
def test_a_marker_is_read_from_its_front(angle: float, expected: bool) -> None:
    """Protects: at grazing angles and from behind the code is not read, however well it is in view."""
    a = np.radians(angle)
    place = TARGET[0] - 5 * np.cos(a), TARGET[1] - 5 * np.sin(a)
    suite = Suite(camera_marker_angle=np.radians(60)).put(*place, heading=angle)
    assert seen(suite) is expected
    assert seen(Suite().put(*place, heading=angle))


def test_turbid_water_takes_range_and_frames() -> None:
    """Protects: the code is lost at 4.8 attenuation lengths (Zaneveld and Pegau 2003), half of the frames
    there, and more of them the farther and the more turbid it is."""

    def share(distance: float, attenuation: float) -> float:
        return Suite(attenuation=attenuation).put(10.0 - distance).hear(2000)["detected"].mean()

    assert share(9.9, 0.0) == share(2.0, 1.0) == 1.0
    assert share(4.8, 1.0) == pytest.approx(0.5, abs=0.04)
    assert share(2.4, 2.0) == pytest.approx(0.5, abs=0.04)
    assert 1.0 > share(4.4, 1.0) > share(4.6, 1.0) > share(5.0, 1.0) > share(5.4, 1.0)
    assert share(7.0, 1.0) == 0.0


def test_a_sight_is_as_old_as_the_latency() -> None:
    """Protects: with 6 cycles of latency and a frame every second one, what is heard is where the plant was
    6 cycles before, and nothing before the first frame is through."""
    suite = Suite(camera_latency=6, camera_period=2)
    heard = []
    for k in range(40):
        heard.append(suite.put(0.1 * k).hear()[0])
    fresh = [k for k, m in enumerate(heard) if m["fresh"]]
    assert fresh == list(range(6, 40, 2))
    assert [m["target"][0] for m in heard if m["fresh"]] == pytest.approx([10 - 0.1 * (k - 6) for k in fresh])


def test_false_sights_come_as_often_as_said_and_anywhere() -> None:
    """Protects: the share of outliers, also while the target is out of sight, all within the view."""
    suite = Suite(camera_outlier=0.1).put(0.0, heading=180.0)
    m = suite.hear(4000)
    false = m[m["detected"] == 1]["target"]
    assert len(false) / len(m) == pytest.approx(0.1, abs=0.015)
    assert false[:, 0].min() < 5 and false[:, 0].max() > 95
    assert np.abs(false[:, 1:]).max() <= np.radians(40) and false[:, 1:].std() > np.radians(20)
    suite.errors["noise_scale"] = 0.0
    assert suite.hear(500)["detected"].sum() == 0
