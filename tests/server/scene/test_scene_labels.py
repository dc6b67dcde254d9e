"""Labels that would lie over each other: the less important one makes way, in that browser alone."""

from types import SimpleNamespace

import numpy as np
import pytest
import viser

from bumpless_server.scene.labels import RULER, Box, Labelled, box_of, spread

CAMERA = SimpleNamespace(
    wxyz=(1.0, 0.0, 0.0, 0.0), position=np.zeros(3), fov=np.pi / 2, image_height=800, aspect=1.5
)


def _label(text: str, anchor: str = "center-center", scale: float = 1.0) -> SimpleNamespace:
    return SimpleNamespace(text=text, anchor=anchor, font_screen_scale=scale)


def test_the_less_important_of_two_makes_way_and_comes_back_with_room_to_spare() -> None:
    """Protects what matters, and the eye from a label that blinks at the edge."""
    status, plane = "/view/status_slot", "/view/world/plane_label_slot"
    boxes = {plane: Box(50, 0, 100, 20), status: Box(0, 0, 60, 20)}
    assert spread(boxes, set()) == {plane}
    touching = boxes | {plane: Box(62, 0, 100, 20)}
    assert spread(touching, set()) == set()
    assert spread(touching, {plane}) == {plane}
    assert spread(boxes | {plane: Box(70, 0, 100, 20)}, {plane}) == set()


def test_a_ruler_that_was_asked_for_never_makes_way() -> None:
    """Protects the browser's own label, which hangs in no frame that could be hidden."""
    assert spread({"/view/status_slot": Box(0, 0, 60, 20), RULER: Box(0, 0, 90, 20)}, set()) == {
        "/view/status_slot"
    }


def test_a_box_is_where_viser_draws_the_label() -> None:
    """A camera at the origin that looks along z, x to the right: 400 px to a metre a metre ahead."""
    box = box_of(_label("0123456789"), np.array([0.5, 0.25, 1.0]), CAMERA)
    assert box is not None
    assert box.left + box.width / 2 == pytest.approx(200.0)
    assert box.top + box.height / 2 == pytest.approx(100.0)
    assert 60 < box.width < 95 and 12 < box.height < 20
    above = box_of(_label("0123456789", "bottom-left"), np.array([0.5, 0.25, 1.0]), CAMERA)
    assert (
        above is not None
        and above.left == pytest.approx(200.0)
        and above.top + above.height == pytest.approx(100)
    )
    assert box_of(_label("behind"), np.array([0.0, 0.0, -1.0]), CAMERA) is None
    assert box_of(_label("beside"), np.array([9.0, 0.0, 1.0]), CAMERA) is None


def test_a_label_stands_where_its_frames_carry_it_and_is_gone_with_them() -> None:
    """Frames move and turn what hangs in them; a hidden one hides it."""
    server = viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
    try:
        scene = Labelled(server.scene)
        frame = scene.add_frame(
            "/view/box", position=(1.0, 2.0, 3.0), wxyz=(np.sqrt(0.5), 0, 0, np.sqrt(0.5))
        )
        label = scene.add_label("/view/box/name", "here", position=(1.0, 0.0, 0.0))
        np.testing.assert_allclose(scene.places()["/view/box/name_slot"], [1.0, 3.0, 3.0], atol=1e-12)
        label.text = ""
        assert not scene.places()
        label.text, frame.visible = "here", False
        assert not scene.places()
    finally:
        server.stop()
