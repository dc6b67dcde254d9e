"""The Live view as its users have it: three arrangements, plots that are held and chosen, words, alarms."""

import re

import pytest
from playwright.sync_api import Page, expect

from bumpless.contract import bumpless_pb2 as pb
from tests.console import flight
from tests.console.contract_server import ContractServer
from tests.console.replies import OLD_RUN_ID, as_json

FOCUSED = """() => {
    const e = document.activeElement;
    if (e === document.body || e.tagName === 'IFRAME') return [e.tagName, true];
    const b = e.getBoundingClientRect();
    const seen = b.width > 0 && b.bottom > 0 && b.top < innerHeight && b.right > 0 && b.left < innerWidth;
    return [e.ariaLabel || e.textContent.trim().slice(0, 40) || e.tagName, seen];
}"""


def in_flight(time_s: float) -> flight.Messages:
    """A vehicle in that moment of its mission."""
    return [*flight.mission_status(time_s), *flight.server_status(recording=True), *flight.cycle(time_s)]


def fly(server: ContractServer, until_s: float, step_s: float = 0.25) -> None:
    """All of the flight so far, then its last moment over and over."""
    server.keep_saying([])
    for k in range(round(until_s / step_s)):
        server.say(flight.cycle(k * step_s))
    server.keep_saying(in_flight(until_s))


def test_three_arrangements_stand_in_the_address(console: Page, server: ContractServer) -> None:
    """Protects a link to what somebody sees, and the choice over a reload."""
    fly(server, 40.0)
    choice = console.get_by_role("group", name="Arrangement")
    choice.get_by_role("button", name="Operate").click()
    expect(console).to_have_url(re.compile(r"#/live\?as=operate$"))
    for question in ("Where is it?", "What is it doing?", "Does it follow?", "What is left?"):
        expect(console.get_by_role("region", name=question, exact=True)).to_be_visible()
    errors = console.get_by_role("region", name="Does it follow?").get_by_role("listitem")
    expect(errors.filter(has_text="Heading")).to_contain_text("of 12.0")
    expect(console.get_by_label("Margin 50 percent")).to_be_visible()  # N: 0.8 of 1.6
    expect(console.get_by_text("At a bound: delta_2")).to_be_visible()
    console.goto(server.url + "#/live?as=wall")
    wall = console.locator(".wall")
    expect(wall).to_contain_text("Reverse")
    expect(wall.get_by_label("Mode Reverse")).to_be_visible()
    large = wall.locator(".wall-figures b").first
    assert large.evaluate("e => e.getBoundingClientRect().height") > 900 / 12, "not to be read from 3 m"
    console.goto(server.url)
    console.reload()  # a link changes nothing that was chosen
    expect(console.get_by_role("region", name="Does it follow?")).to_be_visible()


@pytest.mark.parametrize("size", [(1440, 900), (1024, 768), (1920, 1080), (720, 450)])
@pytest.mark.parametrize("arrangement", ["operate", "wall"])
def test_no_arrangement_overflows(
    console: Page, server: ContractServer, size: tuple[int, int], arrangement: str
) -> None:
    """Protects them on a laptop, a tablet, a wall, and at 200 % of 1440 x 900."""
    console.set_viewport_size({"width": size[0], "height": size[1]})
    console.goto(f"{server.url}#/live?as={arrangement}")
    server.keep_saying(in_flight(46.5))
    expect(console.get_by_label("Mode Hover").first).to_be_attached()
    assert console.evaluate("document.documentElement.scrollWidth") <= size[0]
    cut = console.evaluate(
        """() => [...document.querySelectorAll('.operate .panel-head, .wall-figures dd, .errors li')]
            .filter(e => e.scrollWidth > e.clientWidth + 1).map(e => e.textContent)"""
    )
    assert cut == []


def test_the_wall_shows_no_old_value_as_present(console: Page, server: ContractServer) -> None:
    """Protects who stands three metres away and sees no ages."""
    console.goto(f"{server.url}#/live?as=wall")
    server.keep_saying(flight.server_status(link=pb.LINK_STATE_STALE))
    server.say(in_flight(30.0), age_s=3.0)
    wall = console.locator(".wall")
    expect(wall).to_have_attribute("data-state", "stale")
    expect(wall).to_contain_text("Telemetry late")
    expect(wall).not_to_contain_text("No alarm.")


def test_plots_are_held_and_looked_back_along_while_live(console: Page, server: ContractServer) -> None:
    """Protects: what comes is taken in, the plots stand, and that they do is said."""
    fly(server, 40.0)
    plots = console.get_by_role("region", name="Plots over time")
    speed = console.get_by_test_id("plot-speed").locator(".value-reference")
    expect(speed).to_have_text("0.30")
    plots.focus()
    console.keyboard.press("Space")
    held = console.get_by_role("group", name="Held plots")
    expect(held).to_contain_text("Held, 0.0 s behind")
    server.keep_saying(in_flight(50.0))
    expect(console.get_by_label("Mode Hover")).to_be_visible()
    expect(held).to_contain_text("Held, 10.0 s behind")
    expect(speed).to_have_text("0.30")
    held.get_by_role("slider").fill("12")
    expect(speed).to_have_text("0.70")
    plots.focus()
    console.keyboard.press("End")
    expect(held).to_have_count(0)
    expect(speed).to_have_text("0.00")


def test_a_stretch_is_marked_by_dragging(console: Page, server: ContractServer) -> None:
    """Protects zoom: the stretch alone is shown, in all plots, and a double click gives the present back."""
    fly(server, 40.0)
    expect(console.get_by_label("Mode", exact=True)).to_contain_text("16.0 s in mode")  # all is drawn
    box = console.get_by_label("Depth over time").locator(".u-over").bounding_box()
    assert box is not None
    middle = box["y"] + box["height"] / 2
    console.mouse.move(box["x"] + 0.25 * box["width"], middle)
    console.mouse.down()
    console.mouse.move(box["x"] + 0.5 * box["width"], middle, steps=4)
    console.mouse.up()
    window = console.get_by_label("Time window of plots and mode strip")
    expect(console.get_by_role("group", name="Held plots")).to_contain_text("20.0 s behind")
    expect(window.locator("option:checked")).to_have_text(re.compile(r"^(9\.9|10|10\.[01]) s$"))
    console.mouse.dblclick(box["x"] + 0.5 * box["width"], middle)
    expect(console.get_by_role("group", name="Held plots")).to_have_count(0)


def test_signals_are_searched_chosen_and_kept(console: Page, server: ContractServer) -> None:
    """Protects an operator's own plots over a reload, and layouts by name."""
    fly(server, 10.0)
    console.get_by_label("Choose signals, layouts and a run").click()
    chooser = console.get_by_role("group", name="Signals")
    chooser.get_by_label("Search signals").fill("n_v1")
    chooser.get_by_label("n_v1").check()
    expect(console.get_by_label("n_v1 over time, rpm")).to_be_visible()
    chooser.get_by_label("Name of the layout").fill("Verticals")
    chooser.get_by_role("button", name="Save").click()
    chooser.get_by_label("Search signals").fill("")
    chooser.get_by_label("Range").uncheck()
    expect(console.locator("figure.plot")).to_have_count(3)
    chooser.get_by_role("button", name="Verticals", exact=True).click()
    expect(console.locator("figure.plot")).to_have_count(4)
    console.reload()
    expect(console.locator("figure.plot")).to_have_count(4)


def test_a_ghost_that_cannot_come_says_why(console: Page, server: ContractServer) -> None:
    """Protects from waiting for a line of a run that cannot be read."""
    server.reply("GET", f"runs/{OLD_RUN_ID}/replay", {"detail": "run cannot be replayed"}, status=422)
    fly(server, 10.0)
    console.get_by_label("Choose signals, layouts and a run").click()
    console.get_by_label("Beside it, dotted").select_option(OLD_RUN_ID)
    expect(console.get_by_role("alert")).to_have_text("this run cannot be replayed")
    console.get_by_label("Beside it, dotted").select_option("forecast")
    expect(console.get_by_role("alert")).to_have_text("the vehicle has told no mission")


def test_wrench_bars_keep_their_scale_and_show_what_can_be_attained(
    console: Page, server: ContractServer
) -> None:
    """Protects: bars grew with what had been seen, and a demand out of reach looked like any other."""
    server.keep_saying(in_flight(10.0))
    bar = console.get_by_role("row").filter(has=console.get_by_role("button", name="X", exact=True))
    expect(bar.locator(".bar")).to_have_attribute(
        "title", "Full scale ±5; attainable at this speed −4.00 to +4.00"
    )
    expect(bar.locator(".bar-beyond")).to_have_count(2)
    console.get_by_role("group", name="Wrench as").get_by_role("button", name="Sets").click()
    expect(console.get_by_label("Margin 50 percent")).to_be_visible()
    cuts = console.get_by_role("img", name=re.compile("^Cut of the attainable set"))
    expect(cuts).to_have_count(4)  # no sway: X-Z, and K-M, K-N, M-N


def test_every_symbol_explains_itself_by_keyboard_and_touch(console: Page, server: ContractServer) -> None:
    """Protects newcomers: meaning, unit and formula beside the symbol; Escape gives the place back."""
    server.keep_saying(in_flight(10.0))
    kappa = console.get_by_role("button", name="κ", exact=True)
    kappa.press("Enter")
    card = console.get_by_role("dialog", name="κ: transition factor")
    expect(card).to_contain_text("τ_d = κ τ_d⁺ + (1 − κ) τ_d⁻")
    console.keyboard.press("Escape")
    expect(card).to_be_hidden()
    expect(kappa).to_be_focused()
    console.get_by_role("button", name="KKT residual").dispatch_event("click")
    expect(console.get_by_role("dialog", name="KKT: KKT residual")).to_be_visible()
    small = console.evaluate(
        """() => [...document.querySelectorAll('.term')].filter(e => {
            const s = getComputedStyle(e, '::after'); return e.getClientRects().length
                && (parseFloat(s.height) < 23.5 || parseFloat(s.width) < 23.5) }).map(e => e.textContent)"""
    )
    assert small == [], "targets under 24 px"


@pytest.mark.parametrize("arrangement", ["operate", "engineer", "wall"])
def test_the_keyboard_goes_through_all_of_it(console: Page, server: ContractServer, arrangement: str) -> None:
    """Protects every job by keyboard alone: each control in order, seen while it has the focus, no trap."""
    console.goto(f"{server.url}#/live?as={arrangement}")
    server.keep_saying(in_flight(46.5))
    expect(console.get_by_label("Mode Hover").first).to_be_visible()
    console.evaluate("document.activeElement.blur()")
    seen: list[str] = []
    for _ in range(150):
        console.keyboard.press("Tab")
        name, visible = console.evaluate(FOCUSED)
        if name == "BODY":
            break
        assert visible, f"{name} is not seen while it has the focus"
        seen.append(name)
    assert len(seen) < 150, "the keyboard does not come out again"
    assert any("Hold to abort" in name for name in seen)
    assert any(("Find everything" in name) for name in seen)


def test_a_question_mark_opens_words_and_keys(console: Page, server: ContractServer) -> None:
    """Protects the glossary: searched as one types, with what can be tuned by its own declaration."""
    help_ = {"path": "hover.lambda", "label": "Price of change", "help": "How much a change costs."}
    more = {
        "unit": "",
        "kind": "number",
        "type": "number",
        "required": False,
        "nullable": False,
        "live": True,
    }
    server.reply("GET", "fields/parameters", [help_ | more])
    console.get_by_role("link", name="Runs").focus()
    console.keyboard.press("?")
    sheet = console.get_by_role("dialog", name="Words and keys")
    expect(sheet.get_by_role("region", name="Plots")).to_contain_text("back to the present")
    expect(sheet.get_by_role("region", name="Plan")).to_contain_text("undo and redo")
    sheet.get_by_label("Search words and keys").fill("change costs")
    expect(sheet.get_by_role("article")).to_have_text(re.compile("Price of change"))
    console.keyboard.press("Escape")  # what was searched for
    console.keyboard.press("Escape")
    expect(sheet).to_have_count(0)
    expect(console.get_by_role("link", name="Runs")).to_be_focused()


def test_the_palette_finds_everything(console: Page, server: ContractServer) -> None:
    """Protects the one way to all: views, missions, runs, signals, words, parameters, commands."""
    server.keep_saying(in_flight(10.0))
    expect(console.get_by_label("Mode Forward")).to_be_visible()
    find = console.get_by_role("combobox", name=re.compile("^Find views"))
    for typed, kind in [
        ("plan", "View"),
        ("wall", "View"),
        ("in a current", "Mission"),
        (OLD_RUN_ID, "Run"),
        ("n_v2", "Signal"),
        ("kkt", "Word"),
        ("hover lambda", "Parameter"),
        ("theme", "Do"),
    ]:
        console.keyboard.press("Control+k")
        find.fill(typed)
        option = console.get_by_role("option").filter(has_text=kind).first
        expect(option).to_be_visible()
        console.keyboard.press("Escape")
        expect(find).to_have_count(0)
    console.keyboard.press("Control+k")
    find.fill("mission view")
    console.keyboard.press("ArrowUp")
    console.keyboard.press("Enter")
    expect(console).to_have_title(re.compile("^Missions"))
    console.keyboard.press("Control+k")
    find.fill("nothing of this name")
    expect(console.get_by_role("status").filter(has_text="Nothing of that name.")).to_be_visible()


def test_an_empty_live_view_offers_three_ways_to_begin(console: Page, server: ContractServer) -> None:
    """Protects a newcomer's first minute: the example flies with a caption for each thing that happens."""
    server.reply("POST", "mission/start", {"accepted": True, "reason": ""})
    steps = console.get_by_role("region", name="First steps")
    for name in ("Fly it", "Open the planner", "Show the runs"):
        expect(steps.get_by_role("button", name=name)).to_be_enabled()
    steps.get_by_role("button", name="Fly it").click()
    body = server.wait_for_call("POST", "mission/start").json()
    assert body["name"] == "docking.yaml" and body["sha256"].startswith("5f2a9c")
    caption = console.get_by_role("region", name="What happens")
    words = {10.0: "Forward: it cruises", 30.0: "Reverse: the range", 50.0: "Hover: at the"}
    for time_s, word in words.items():
        server.keep_saying(in_flight(time_s))
        expect(caption).to_contain_text(word)
    caption.get_by_role("button", name="Close the captions").click()
    expect(caption).to_have_count(0)
    expect(console.get_by_role("main")).to_be_focused()
    expect(steps).to_have_count(0)


ALARMS = (
    (1, pb.SEVERITY_ALARM, "node_died", "Critical"),
    (2, pb.SEVERITY_ALARM, "leak", "Alarm"),
    (3, pb.SEVERITY_WARNING, "tracking_depth", "Warning"),
    (4, pb.SEVERITY_WARNING, "saturated", "Low"),
    (5, pb.SEVERITY_WARNING, "clock_offset", "Note"),
)


def alarm(priority: int, severity: "pb.Severity", code: str, **said: int | str) -> pb.Alarm:
    """One that holds."""
    text = f"Of {code}."
    one = pb.Alarm(id=code, code=code, severity=severity, priority=priority, text=text)
    one.raised_ns = flight.START_NS
    for name, value in said.items():
        setattr(one, name, value)
    return one


def test_alarms_stand_by_priority_each_in_its_own_shape(console: Page, server: ContractServer) -> None:
    """Protects five priorities told without colour, most urgent first, with who has seen which and when."""
    said = [alarm(*one[:3]) for one in ALARMS]
    said[1].acknowledged_ns, said[1].acknowledged_by = flight.START_NS, "Ada"
    server.say([("server/alarms", pb.Alarms(alarms=said))])
    counts = console.get_by_role("group", name="Alarms by priority")
    expect(counts.locator(".alarm-counts > span")).to_have_text([f"{name} 1" for *_, name in ALARMS])
    shapes = counts.locator(".alarm-counts svg").evaluate_all("all => all.map(e => e.innerHTML)")
    assert len(set(shapes)) == 5
    bar = console.get_by_role("region", name="Alarms")
    expect(bar.get_by_role("listitem")).to_contain_text("Of node_died.")
    counts.get_by_role("button", name=re.compile("Critical")).click()
    leak = bar.get_by_role("listitem").filter(has_text="Of leak.")
    expect(leak).to_contain_text("seen by Ada at 08:53:20 UTC")


def test_what_is_over_can_be_read_again(console: Page, server: ContractServer) -> None:
    """Protects the history: what was raised, gone, and seen by whom, also where nothing is open."""
    over = alarm(1, pb.SEVERITY_ALARM, "node_died", returned_ns=1, acknowledged_by="Ada")
    server.reply("GET", "alarms", {"open": [], "history": [as_json(over)]})
    bar = console.get_by_role("region", name="Alarms", exact=True)
    expect(bar).to_have_count(0)
    console.get_by_role("group", name="Alarms by priority").get_by_role("button", name="No alarm").click()
    expect(bar).to_contain_text("No alarm is open.")
    expect(bar.get_by_label("Alarms that are over")).to_contain_text("Of node_died. seen by Ada")


def test_an_alarm_is_shelved_for_as_long_as_is_chosen(console: Page, server: ContractServer) -> None:
    """Protects from an alarm put aside for longer, or shorter, than was meant."""
    server.reply("POST", "alarms/saturated/shelve", None)
    server.say([("server/alarms", pb.Alarms(alarms=[alarm(*ALARMS[3][:3])]))])
    bar = console.get_by_role("region", name="Alarms")
    bar.get_by_label("Shelve for").select_option("1 h")
    bar.get_by_role("button", name="Shelve").click()
    assert server.wait_for_call("POST", "alarms/saturated/shelve").json()["seconds"] == 3600


def test_alarms_are_seen_by_who_is_in_control(console: Page, server: ContractServer) -> None:
    """Protects from an alarm that somebody looking on put away before the crew had read it."""
    server.keep_saying(flight.held_by("another", "Ada"))
    server.say([("server/alarms", pb.Alarms(alarms=[alarm(*ALARMS[3][:3])]))])
    bar = console.get_by_role("region", name="Alarms")
    for name in ("Seen", "Shelve"):
        expect(bar.get_by_role("button", name=name)).to_be_disabled()
        expect(bar.get_by_role("button", name=name)).to_have_attribute(
            "title", "Another operator is in control"
        )


def test_alarms_are_silent_until_somebody_wants_to_hear_them(console: Page, server: ContractServer) -> None:
    """Protects a room from noise that nobody asked for, and who asked for it from missing one."""
    console.evaluate(
        """() => { window.tones = 0; const start = OscillatorNode.prototype.start;
            OscillatorNode.prototype.start = function (...a) {
                window.tones += 1; return start.apply(this, a) } }"""
    )
    bar = console.get_by_role("region", name="Alarms")
    server.say([("server/alarms", pb.Alarms(alarms=[alarm(*ALARMS[1][:3])]))])
    expect(bar).to_be_visible()
    assert console.evaluate("window.tones") == 0
    sound = console.get_by_role("button", name="Sound of new alarms")
    sound.click()
    expect(sound).to_have_attribute("aria-pressed", "true")
    before = console.evaluate("window.tones")
    server.say([("server/alarms", pb.Alarms(alarms=[alarm(*one[:3]) for one in ALARMS[:2]]))])
    expect(bar).to_contain_text("Of node_died.")
    assert console.evaluate("window.tones") == before + 3, "a critical alarm is three tones"


def test_a_past_switch_shows_its_ramp_and_its_cost_beside_the_last_run(
    console: Page, server: ContractServer
) -> None:
    """Protects "what did this switch cost": step of the commands, κ and weights, and yesterday's."""
    server.keep_saying([])
    for k in range(540):
        server.say(flight.cycle(20.0 + 0.05 * k))
    server.keep_saying(in_flight(47.0))
    told = {"from": "forward", "to": "reverse", "unless": "a range above it"}
    server.say(flight.event(24.0, pb.SEVERITY_INFO, "mode_switch", "Forward to reverse: range.", **told))
    event = console.get_by_role("log").get_by_role("listitem")
    event.get_by_text("Forward to reverse").click()
    expect(event).to_contain_text("a range above it")
    expect(event).to_contain_text(re.compile(r"step of the commands0\.0\d{3} , last run's 0\.0456"))
    expect(event.get_by_role("img", name="Transition factor and weights through the ramp")).to_be_visible()
