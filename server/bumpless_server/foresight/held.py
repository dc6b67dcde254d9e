"""On which headings a vehicle holds station, for a screen: from the function that the check uses."""

import contextlib
import math
from typing import Literal

from bumpless.config.mission import MissionError, parse_mission
from bumpless.config.mission.model import Target
from bumpless.config.parameters import ParameterError, default_parameters, from_message
from bumpless.config.vehicle import Vehicle
from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import MOVING, TRANSIT
from bumpless.runs.checked import ACCEPT, REFUSE, WARN, Station, arcs, station_keeping
from bumpless_server.foresight.told import HeldArc, HeldStation
from bumpless_server.live.state import State

_Zone = Literal["accepted", "warned", "refused"]
_Ned = tuple[float, float, float]
ZONES: dict[int, _Zone] = {ACCEPT: "accepted", WARN: "warned", REFUSE: "refused"}


def told(station: Station, current_ned_mps: _Ned) -> HeldStation:
    """Station keeping in a current as stretches of headings that are alike."""
    whole = (station.heading_deg[0], station.heading_deg[-1])
    found = []
    for zone, word in ZONES.items():
        alike = station.zone == zone
        stretches = [whole] if alike.all() else arcs(station.heading_deg, alike)
        found += [HeldArc(zone=word, from_deg=float(a), to_deg=float(b)) for a, b in stretches]
    return HeldStation(
        current_ned_mps=[round(one, 4) for one in current_ned_mps],
        arcs=found,
        heading_deg=round(station.chosen_deg % 360.0, 1),
        zone=ZONES[station.chosen.zone],
        reason=station.chosen.reason,
    )


def station_now(state: State, vehicle: Vehicle | None) -> HeldStation | None:
    """What holds in the current that the vehicle estimates now, and whether the heading it has taken does.

    In transit it has taken none yet: there the one counts that it would take, by its mission.
    None where nothing flies that is heard, and for a vehicle that only passes its target by.
    """
    said = {topic: state.latest(topic) for topic in ("mission", "navigation", "target", "parameters")}
    mission, navigation, target, parameters = said.values()
    if vehicle is None or state.link != pb.LINK_STATE_LIVE:
        return None
    if not isinstance(mission, pb.MissionStatus) or mission.phase not in MOVING:
        return None
    if not isinstance(navigation, pb.Navigation) or not isinstance(target, pb.Target):
        return None
    own = default_parameters(vehicle)
    with contextlib.suppress(ParameterError):  # of a vehicle that goes by other rules: what its file says
        if isinstance(parameters, pb.ParametersStatus):
            own = from_message(parameters.active, own)
    flow = navigation.current_estimate_ned_mps
    current = (flow.x, flow.y, flow.z)
    if own.guidance.speed_min_mps > 0.0 or not all(map(math.isfinite, (*current, target.heading_deg))):
        return None
    taken = _to_be_taken(state) or Target((0.0, 0.0, 0.0), target.heading_deg, 0.0)
    return told(station_keeping(vehicle, own, current, taken), current)


def _to_be_taken(state: State) -> Target | None:
    """The planned target while the vehicle has not turned its approach yet; None where it has."""
    supervisor, plan = state.latest("supervisor"), state.latest("plan")
    if not isinstance(supervisor, pb.Supervisor) or supervisor.docking_stage != TRANSIT:
        return None
    if isinstance(plan, pb.Plan):
        with contextlib.suppress(MissionError):  # of a vehicle whose missions are written otherwise
            return parse_mission(plan.mission_yaml, plan.file_name).target
    return None
