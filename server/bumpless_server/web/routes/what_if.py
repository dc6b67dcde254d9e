"""What a draft of parameters would do, flown ahead from where the vehicle is."""

from fastapi import APIRouter
from fastapi.concurrency import run_in_threadpool
from google.protobuf.message import Message

from bumpless.contract import bumpless_pb2 as pb
from bumpless_server.live import tuning
from bumpless_server.scene.ghosts import ghost_of
from bumpless_server.web.answers.refusal import REFUSALS
from bumpless_server.web.errors import Refusal
from bumpless_server.web.routes import Served
from bumpless_server.what_if.desk import NoFlight
from bumpless_server.what_if.told import AheadTask, WhatIf, WhatIfRequest

router = APIRouter(prefix="/api", responses=REFUSALS)

SAID = (
    "description", "plan", "parameters", "navigation", "guidance", "supervisor", "control", "actuators",
    "target", "mission",
)  # fmt: skip


@router.post("/what-if")
async def what_if(console: Served, body: WhatIfRequest) -> WhatIf:
    """Fly the draft, and what is in force, from the vehicle's present state; nothing is changed on it."""
    if console.state.link != pb.LINK_STATE_LIVE:
        raise Refusal(409, "the vehicle is not heard now: where to fly on from is not known")
    draft = await run_in_threadpool(lambda: tuning.parse(body.parameters, console.vehicle()))
    said: dict[str, Message] = {name: found for name in SAID if (found := console.state.latest(name))}
    task = AheadTask(
        number=0,
        said={name: message.SerializeToString().hex() for name, message in said.items()},
        draft=draft.SerializeToString().hex(),
        horizon_s=body.horizon_s,
    )
    try:
        pair = await console.what_if.ask(task)
    except NoFlight as error:
        raise Refusal(503, str(error)) from error
    if pair.as_it_is is None or pair.draft is None:
        raise Refusal(422, f"it cannot be flown ahead: {pair.problem}")
    mission, status, navigation = said.get("mission"), said.get("parameters"), said.get("navigation")
    run = mission.run_id if isinstance(mission, pb.MissionStatus) else ""
    flights = {"as_it_is": pair.as_it_is, "draft": pair.draft}
    console.ghosts.put(run, {name: ghost_of(one.time_s, one.columns) for name, one in flights.items()})
    return WhatIf(
        run=run,
        from_s=navigation.stamp.mission_time_s if isinstance(navigation, pb.Navigation) else 0.0,
        revision=status.revision if isinstance(status, pb.ParametersStatus) else 0,
        as_it_is=pair.as_it_is,
        draft=pair.draft,
    )
