"""Who holds control of the vehicle: asked for, handed over, taken with a reason, given up."""

from fastapi import APIRouter
from fastapi.concurrency import run_in_threadpool

from bumpless_server.web.answers.contract import told
from bumpless_server.web.answers.control import AskForControl, ControlHolder, ForClient, TakeControl
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.known import Asking
from bumpless_server.web.routes import Served
from bumpless_server.web.routes.people import AtDoor

router = APIRouter(prefix="/api", responses=REFUSALS)


@router.get("/control")
async def control(console: Served) -> ControlHolder:
    """Who holds control, and who asks for it."""
    return told(console.lease.state(), ControlHolder)


@router.post("/control/ask")
async def ask(console: Served, door: AtDoor, asking: Asking, wanted: AskForControl) -> ControlHolder:
    """Ask for control; where nobody holds it, it is given at once."""
    console.lease.ask(asking, wanted.reason.strip())
    await _note(door, asking, "ask_for_control", reason=wanted.reason.strip())
    return await control(console)


@router.post("/control/take")
async def take(console: Served, door: AtDoor, asking: Asking, wanted: TakeControl) -> ControlHolder:
    """Take control from its holder; everybody reads why."""
    reason = wanted.reason.strip()
    if len(reason) < 3:
        raise Refusal(422, "say why control is taken")
    before = console.lease.state().holder_name
    console.lease.take(asking, reason)
    await _note(door, asking, "take_control", holder=[before, asking.shown], reason=reason)
    return await control(console)


@router.post("/control/hand")
async def hand(console: Served, door: AtDoor, asking: Asking, to: ForClient) -> ControlHolder:
    """The holder hands control over."""
    try:
        console.lease.hand_over(asking, to.client)
    except KeyError:
        raise Refusal(404, "nobody here has that id") from None
    after = console.lease.state().holder_name
    await _note(door, asking, "hand_control", holder=[asking.shown, after])
    return await control(console)


@router.post("/control/decline")
async def decline(console: Served, door: AtDoor, asking: Asking, whom: ForClient) -> ControlHolder:
    """The holder answers a request with no."""
    try:
        console.lease.decline(asking, whom.client)
    except KeyError:
        raise Refusal(404, "nobody with that id asks for control") from None
    await _note(door, asking, "decline_control", client=whom.client)
    return await control(console)


@router.post("/control/release")
async def release(console: Served, door: AtDoor, asking: Asking) -> ControlHolder:
    """Give control up, or stop asking for it."""
    console.lease.let_go(asking)
    await _note(door, asking, "release_control")
    return await control(console)


async def _note(door: AtDoor, asking: Asking, verb: str, **details: object) -> None:
    await run_in_threadpool(door.note, asking.shown, verb, **details)
