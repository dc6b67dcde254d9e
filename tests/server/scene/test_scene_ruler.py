"""The ruler: what a click means, and what it says."""

import numpy as np
import pytest

from bumpless_server.scene.places import Places
from bumpless_server.scene.ruler import DOCK, IN_SIGHT_M, VEHICLE, End, Ruler, picked, ruler_text

PLACES = Places(
    vehicle=np.array([10.0, 0.0, 3.0]),
    path=np.array([[0.0, 0.0, 3.0], [25.0, 0.0, 3.0]]),
    target=np.array([26.0, 0.0, 5.0]),
)


class Node:
    """A node of a scene that only remembers."""

    visible, text, removed = False, "", False
    points = position = None

    def remove(self) -> None:
        self.removed = True


class Paper:
    """A scene that draws nothing."""

    def add_line_segments(self, *_: object, **__: object) -> Node:
        return Node()

    add_label = add_line_segments


def look(at: tuple[float, float, float]) -> End | None:
    """What is picked by a look from 10 m above the vehicle at a place."""
    eye = np.array([10.0, -8.0, -7.0])
    return picked(eye, 0.37 * (np.array(at) - eye), PLACES)


def test_a_click_means_the_thing_it_is_near_else_a_place_at_the_vehicles_depth() -> None:
    """Vehicle and dock are known by name, a corner of the path is exact, water is at the vehicle's depth."""
    assert look((10.0, 0.1, 3.1)) == End(VEHICLE)
    assert look((26.0, 0.0, 5.0)) == End(DOCK)
    assert look((25.0, 0.0, 3.0)) == End(place=(25.0, 0.0, 3.0))
    water = look((15.0, 6.0, 3.0))
    assert water is not None and not water.thing
    np.testing.assert_allclose(water.place, (15.0, 6.0, 3.0))
    assert picked(np.zeros(3), np.array([0.0, 1.0, -1.0]), PLACES) is None, "the sky"
    assert picked(np.zeros(3), np.array([0.0, 1.0, 1e-9]), PLACES) is None, "level, at no depth"


def test_it_says_distance_bearing_and_depth() -> None:
    """From the first end to the second, as navigators say it."""
    assert (
        ruler_text(PLACES.vehicle, np.array([10.0, 3.0, 7.0]))
        == "5.00 m · level 3.00 m to 090° · 4.00 m deeper"
    )
    assert ruler_text(PLACES.vehicle, np.array([10.0, 0.0, 1.0])) == "2.00 m · 2.00 m shallower"
    assert ruler_text(PLACES.vehicle, PLACES.vehicle) == "0.00 m"


def test_it_begins_at_the_dock_and_then_measures_on_from_click_to_click() -> None:
    """One click is from the vehicle, two are between what was clicked; things are followed as they move."""
    ruler = Ruler(Paper())
    ruler.draw(PLACES)
    assert ruler.line.visible and ruler.label.text.startswith("16.12 m")
    assert np.linalg.norm(ruler.label.position) == pytest.approx(IN_SIGHT_M), "seen though the dock is far"
    ruler.pick(End(place=(10.0, 3.0, 3.0)))
    ruler.draw(PLACES)
    assert ruler.label.text == "3.00 m · level 3.00 m to 090°"
    ruler.pick(End(DOCK))
    ruler.draw(PLACES)
    assert ruler.ends == (End(place=(10.0, 3.0, 3.0)), End(DOCK))
    ruler.pick(End(VEHICLE))
    moved = Places(vehicle=np.array([26.0, 0.0, 4.0]), target=PLACES.target)
    ruler.draw(moved)
    assert ruler.label.text == "1.00 m · 1.00 m shallower"
    np.testing.assert_allclose(ruler.line.points, [[[0.0, 0.0, 1.0], [0.0, 0.0, 0.0]]])


def test_without_a_dock_it_says_so_and_measures_what_is_clicked() -> None:
    """Protects from a line to where no dock is."""
    ruler, nowhere = Ruler(Paper()), Places(vehicle=np.array([1.0, 0.0, 3.0]))
    ruler.draw(nowhere)
    assert not ruler.line.visible and "no dock" in ruler.label.text
    ruler.pick(End(place=(4.0, 0.0, 3.0)))
    ruler.draw(nowhere)
    assert ruler.line.visible and ruler.label.text == "3.00 m · level 3.00 m to 000°"
