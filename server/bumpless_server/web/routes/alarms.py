"""Alarms: those there are and were; seen, or kept out of the way for a time."""

from typing import Annotated

from fastapi import APIRouter, Body, Response

from bumpless.contract.messages import as_json
from bumpless_server.alarms.limits import Limits
from bumpless_server.web.answers.alarms import Alarm, AlarmsAnswer
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.known import Asking
from bumpless_server.web.ledger import Done
from bumpless_server.web.routes import Served

router = APIRouter(prefix="/api/alarms", responses=REFUSALS)
LONGEST_S = 8 * 3600.0


@router.get("")
def alarms(console: Served) -> AlarmsAnswer:
    """All alarms."""
    open_, over = (
        [Alarm.model_validate(as_json(alarm.message())) for alarm in found]
        for found in (console.alarms.open(), console.alarms.history())
    )
    return AlarmsAnswer(open=open_, history=over)


@router.get("/limits")
def limits(console: Served) -> Limits:
    """How far the vehicle may be off before somebody is told: of its file, else the defaults."""
    return console.alarms.limits


@router.post("/{alarm}/acknowledge", status_code=204)
def acknowledge(console: Served, deed: Done, asking: Asking, alarm: str) -> Response:
    """Who is in control has seen it. One whose cause has gone is over with that."""
    console.lease.use(asking)
    deed.tell(**_named(console, alarm))
    if not console.alarms.acknowledge(alarm, asking.shown):
        raise Refusal(404, f"there is no alarm {alarm!r}: it may be over")
    return Response(status_code=204)


@router.post("/{alarm}/shelve", status_code=204)
def shelve(
    console: Served,
    deed: Done,
    asking: Asking,
    alarm: str,
    seconds: Annotated[float, Body(gt=0.0, le=LONGEST_S, embed=True)] = 600.0,
) -> Response:
    """Keep it out of the way for a time; it comes back by itself. For who is in control."""
    console.lease.use(asking)
    deed.tell(**_named(console, alarm), seconds=seconds)
    if not console.alarms.shelve(alarm, seconds, asking.shown):
        raise Refusal(404, f"there is no alarm {alarm!r}: it may be over")
    return Response(status_code=204)


def _named(console: Served, alarm: str) -> dict[str, str]:
    """What an alarm says: its id alone would tell the audit's reader nothing."""
    found = (one.message() for one in console.alarms.open() if one.id == alarm)
    return next(({"code": one.code, "text": one.text} for one in found), {})
