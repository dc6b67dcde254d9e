"""A real browser opens the scene through the real proxy and sees the vehicle, its mode and its staleness."""

import io
from collections.abc import Callable, Iterator

import numpy as np
import pytest
from PIL import Image
from playwright.sync_api import Page, expect

from bumpless.config.vehicle import Vehicle, load_vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.scene import palette
from bumpless_server.scene.attainable import Sets
from bumpless_server.scene.hull_mesh import hull_mesh
from bumpless_server.scene.ruler import VEHICLE, End
from tests.server.scene.harness import Served, serve

PATIENCE_MS = 60_000  # software rendering on a busy machine


def _sets(_: Vehicle) -> Callable[[float], Sets]:
    cube = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], float)
    return lambda speed: Sets(speed, hull_mesh(4.0 * cube), hull_mesh(2.0 * cube))


@pytest.fixture(scope="module")
def served() -> Iterator[Served]:
    with serve(make_sets=_sets, light=True) as running:
        yield running


class Flight:
    """A vehicle that says every cycle what the contract asks for."""

    def __init__(self, served: Served) -> None:
        self.served, self.cycle = served, 0
        vehicle = load_vehicle("ts100")
        served.tell(
            "description",
            pb.VehicleDescription(vehicle_id="ts100", vehicle_toml=vehicle.text, sha256=vehicle.sha256),
        )
        path = [pb.Vector3(x=float(x), z=3.0) for x in (0, 15, 25)]
        served.tell("plan", pb.Plan(path_ned_m=path))
        served.tell("mission", pb.MissionStatus(phase=pb.MISSION_PHASE_RUNNING, run_id="run"))

    def fly(self, mode: pb.Mode) -> None:
        """One cycle."""
        self.cycle += 1
        stamp = pb.Stamp(time_ns=self.cycle * 50_000_000, cycle=self.cycle)
        north = 0.03 * self.cycle
        tell = self.served.tell
        tell("supervisor", pb.Supervisor(stamp=stamp, mode=mode, kappa=1.0, range_fr_lower_m=8.0))
        rudders = [pb.Actuator(name=f"delta_{k}", unit="deg", feedback=10.0) for k in range(1, 5)]
        screws = [pb.Actuator(name=name, unit="rpm", feedback=120.0) for name in ("n_p", "n_v1", "n_v2")]
        tell("actuators", pb.Actuators(stamp=stamp, actuators=rudders + screws))
        wrench = pb.Wrench(x_n=3.0, z_n=-1.0, m_nm=1.0)
        tell("control", pb.Control(stamp=stamp, demanded=wrench, achieved=wrench))
        target = pb.Vector3(x=26.0, z=3.0)
        point = pb.Vector3(x=24.5, z=3.0)
        tell("target", pb.Target(stamp=stamp, position_ned_m=target, observation_point_ned_m=point))
        tell("navigation", pb.Navigation(stamp=stamp, position_ned_m=pb.Vector3(x=north, z=3.0), depth_m=3.0))


@pytest.fixture
def flight(served: Served) -> Flight:
    return Flight(served)


def _open(page: Page, served: Served, query: str = "") -> None:
    page.set_viewport_size({"width": 640, "height": 370})
    page.goto(f"{served.origin}/")
    page.goto(f"{served.origin}/scene/?quality=light{query}")
    expect(page.locator("html")).to_have_attribute("data-link", "live", timeout=PATIENCE_MS)


def _pixels(page: Page) -> np.ndarray:
    return np.asarray(Image.open(io.BytesIO(page.screenshot())).convert("RGB"), np.int16)


def _share(picture: np.ndarray, colour: palette.Rgb) -> float:
    """Share of pixels with about the colour's hue, saturated: shading changes brightness, not hue."""
    wanted = np.asarray(colour, float) / max(colour)
    strength = picture.max(axis=2, keepdims=True)
    seen = picture / np.maximum(strength, 1)
    return float(((np.abs(seen - wanted) < 0.16).all(axis=2) & (strength[..., 0] > 60)).mean())


def _frame(page: Page) -> None:
    """Wait until the browser has drawn once more."""
    page.wait_for_function("new Promise(r => requestAnimationFrame(() => r(true)))")


def _until(page: Page, condition: Callable[[], bool]) -> None:
    """Let the browser draw on until the server's side has come so far, or patience ends."""
    for _ in range(1200):
        if condition():
            return
        _frame(page)


def _fly_until(page: Page, flight: Flight, mode: pb.Mode, seen: Callable[[np.ndarray], bool]) -> np.ndarray:
    """Fly on until the picture shows what it should; the last picture either way."""
    picture = _pixels(page)
    for _ in range(40):
        for _ in range(5):
            flight.fly(mode)
            _frame(page)
        picture = _pixels(page)
        if seen(picture):
            break
    return picture


def test_vehicle_and_mode_are_seen(page: Page, served: Served, flight: Flight) -> None:
    """The hull stands in the middle of the picture; its bands and track change colour with the mode."""
    _open(page, served)
    blue = _fly_until(page, flight, pb.MODE_FORWARD, lambda p: _share(p, palette.FORWARD) > 5e-4)
    assert _share(blue, palette.FORWARD) > 5e-4
    middle = blue[120:300, 160:480]
    assert ((middle.min(axis=2) > 130) & (np.ptp(middle, axis=2) < 30)).mean() > 0.01, "no pale hull"
    green = _fly_until(page, flight, pb.MODE_HOVER, lambda p: _share(p, palette.HOVER) > 5e-4)
    assert _share(green, palette.HOVER) > 5e-4


def test_nothing_stale_looks_live(page: Page, served: Served, flight: Flight) -> None:
    """When telemetry stops, mode colours leave the vehicle and the label says how old the data is."""
    _open(page, served)
    _fly_until(page, flight, pb.MODE_HOVER, lambda p: _share(p, palette.HOVER) > 5e-4)
    picture = served.scene.live.picture
    _until(page, lambda: picture.label.text.startswith("STALE"))
    assert picture.label.text.startswith("STALE")
    assert picture.vehicle.nodes["accent"].color == palette.STALE
    assert not picture.force.demanded.visible


def test_cameras_are_each_operators_own(page: Page, served: Served, flight: Flight) -> None:
    """A preset moves the caller's browser and no other session's."""
    _open(page, served)
    other = page.context.browser
    assert other is not None
    context = other.new_context()
    second = context.new_page()
    try:
        _open(second, served)
        _until(second, lambda: len(served.scene.cameras) == 2)
        moved = page.request.post(
            f"{served.origin}/api/scene/camera", data={"view": "top"}, headers={"Origin": served.origin}
        )
        assert moved.json() == {"view": "top", "viewers": 1}
        assert sorted(served.scene.cameras.views()) == ["follow", "top"]
    finally:
        context.close()


def test_a_ruler_measures_in_its_own_picture_from_click_to_click(
    page: Page, served: Served, flight: Flight, monkeypatch: pytest.MonkeyPatch
) -> None:
    """From vehicle to dock as it is laid down, then to what is clicked; other operators see none of it."""
    _open(page, served)
    _fly_until(page, flight, pb.MODE_FORWARD, lambda p: _share(p, palette.FORWARD) > 5e-4)

    def lay(on: bool) -> object:
        address, headers = f"{served.origin}/api/scene/ruler", {"Origin": served.origin}
        return page.request.post(address, data={"on": on}, headers=headers).json()

    assert lay(True) == {"on": True, "viewers": 1}
    cameras = served.scene.cameras
    (ruler,) = cameras.rulers()
    expected = 26.0 - cameras.places.vehicle[0]
    assert float(ruler.label.text.split(" m")[0]) == pytest.approx(expected, abs=0.2)
    measured: list[tuple[End, End]] = []
    pick = ruler.pick

    def heard(end: End) -> None:
        pick(end)
        measured.append(ruler.ends)

    monkeypatch.setattr(ruler, "pick", heard)
    # Clicks go on until two are heard: a browser that is behind doesn't listen for the first ones yet,
    # and one that is slow delivers several at once.
    _until(page, lambda: not page.mouse.click(320, 290) and len(measured) > 1)
    assert measured[0][0] == End(VEHICLE) and measured[0][1].thing != VEHICLE
    assert measured[1][0] == measured[0][1], "the next line begins where the last one ended"
    assert lay(False) == {"on": False, "viewers": 1}
    assert not cameras.rulers()


def test_light_theme_and_own_panel(page: Page, served: Served, flight: Flight) -> None:
    """The console's light theme reaches the background, and viser's own controls stay hidden."""
    _open(page, served, "&theme=light")
    assert _pixels(page)[:40].mean() > 200
    expect(page.locator("[data-floating-window]:visible")).to_have_count(0)
    expect(page.get_by_text("τ_d demanded")).to_be_visible()


def test_it_says_so_when_the_server_is_gone(page: Page, flight: Flight) -> None:
    """A dead link greys the picture and is named, whatever was last drawn."""
    with serve(make_sets=_sets, light=True) as short_lived:
        _open(page, short_lived)
    expect(page.locator("html")).to_have_attribute("data-link", "lost", timeout=PATIENCE_MS)
    expect(page.get_by_text("picture is not live")).to_be_visible()


FRAMED = """address => {
  document.body.innerHTML = "<iframe id=scene style='width: 640px; height: 370px'></iframe>";
  document.getElementById("scene").src = address;
}"""
COUNTED = """() => {
  const draw = WebGL2RenderingContext.prototype.drawElements;
  window.drawn = 0;
  WebGL2RenderingContext.prototype.drawElements = function (...all) {
    window.drawn++;
    draw.apply(this, all);
  };
}"""


def test_an_unseen_scene_draws_nothing_and_is_up_to_date_when_seen(
    page: Page, served: Served, flight: Flight
) -> None:
    """Protects the machine from a scene that renders behind another view, and the first look at it after."""
    _open(page, served)
    _fly_until(page, flight, pb.MODE_FORWARD, lambda p: _share(p, palette.FORWARD) > 5e-4)
    address = page.url
    page.goto(f"{served.origin}/api/health")  # the same origin, nothing else drawn
    page.evaluate(FRAMED, address)
    frame = page.frame_locator("#scene").locator("html")
    expect(frame).to_have_attribute("data-link", "live", timeout=PATIENCE_MS)
    expect(frame).to_have_attribute("data-seen", "yes")
    scene = page.frames[-1]
    scene.evaluate(COUNTED)

    def drawn_over(mode: pb.Mode) -> int:
        """Draw calls while the vehicle flies on, and the server draws for this browser."""
        before, pictures = scene.evaluate("window.drawn"), served.scene.live.pictures
        for _ in range(200):
            flight.fly(mode)
            _frame(page)
            if served.scene.live.pictures >= pictures + 10:
                break
        return scene.evaluate("window.drawn") - before

    assert drawn_over(pb.MODE_FORWARD) > 0
    page.evaluate("document.getElementById('scene').hidden = true")
    page.wait_for_function("scene.contentDocument.documentElement.dataset.seen === 'no'")
    assert drawn_over(pb.MODE_HOVER) == 0
    page.evaluate("document.getElementById('scene').hidden = false")
    expect(frame).to_have_attribute("data-seen", "yes")
    assert drawn_over(pb.MODE_HOVER) > 0
    green = _fly_until(page, flight, pb.MODE_HOVER, lambda p: _share(p, palette.HOVER) > 5e-4)
    assert _share(green, palette.HOVER) > 5e-4
