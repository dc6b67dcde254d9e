"""Words beside the vehicle: mode, or why the picture is not live."""

from math import isfinite

from bumpless.contract import bumpless_pb2 as pb
from bumpless.contract.enums import HOVER, MOVING, PAUSED
from bumpless.contract.modes import LOOKS

PHASE_NAME: dict[int, str] = {
    pb.MISSION_PHASE_IDLE: "Idle",
    pb.MISSION_PHASE_PAUSED: "Holding station",
    pb.MISSION_PHASE_COMPLETED: "Mission over, holding station",
    pb.MISSION_PHASE_ABORTED: "Aborted: drifting",
}


def trail_mode(phase: int, mode: int) -> int:
    """The mode whose colour counts: none while no control is in force."""
    return mode if phase in MOVING else pb.MODE_UNSPECIFIED


def flown_mode(phase: int, supervisor: pb.Supervisor) -> int:
    """Whose gains count; of a vehicle that does not say, H in a pause."""
    return supervisor.flown or (HOVER if phase == PAUSED else supervisor.mode)


def body_text(
    link: int, age_s: float, phase: int, supervisor: pb.Supervisor, navigation: pb.Navigation
) -> str:
    """One line over the vehicle."""
    if link == pb.LINK_STATE_WAITING:
        return "waiting for a vehicle"
    if link in (pb.LINK_STATE_STALE, pb.LINK_STATE_LOST):
        word = "LINK LOST" if link == pb.LINK_STATE_LOST else "STALE"
        age = f"{age_s:.0f} s old" if isfinite(age_s) else "nothing received"
        return f"{word} · last telemetry {age}"
    words = [PHASE_NAME[phase]] if phase in PHASE_NAME else []
    if phase in MOVING:
        look = LOOKS.get(flown_mode(phase, supervisor))
        words.append(f"{look.letter} · {look.name}" if look else "no mode")
        if supervisor.kappa < 1.0:
            words[-1] += f"  κ {supervisor.kappa:.2f}"
    words.append(f"{navigation.speed_over_ground_mps:.2f} m/s · depth {navigation.depth_m:.2f} m")
    return " · ".join(words)
