"""What a vehicle does by itself when something fails, as its file says."""

from dataclasses import dataclass
from typing import Annotated, Literal

from bumpless.config.declare import Choice, Number, model

# from the mildest to the hardest; a milder one never undoes a harder one that is in force
Reaction = Literal["none", "hold", "wave_off", "surface", "abort"]
REACTIONS: tuple[Reaction, ...] = ("none", "hold", "wave_off", "surface", "abort")
WORDS: dict[Reaction, str] = {
    "none": "goes on",
    "hold": "holds station",
    "wave_off": "backs off from the dock and holds station",
    "surface": "holds station at the surface",
    "abort": "stops its actuators",
}


def does(when: str) -> Choice:
    """A reaction to `when`."""
    return Choice(f"What it does when {when}")


def limit(label: str, unit: str, most: float) -> Number:
    """A limit that is not watched when 0."""
    return Number(label, unit, 0.0, most, help="0: not watched.")


@dataclass(frozen=True)
class Declared:
    """One line of "what happens when": `limit` is None where there is no number to it."""

    cause: str
    when: str  # one sentence
    reaction: Reaction
    limit: float | None = None
    unit: str = ""


@model
class Failsafe:
    """Reactions of the vehicle's node: hold station, wave off, surface, or stop the actuators (abort).

    Without this table it flies its mission to the end, and stops only where its own state is no number any
    more, or when it comes back from a crash.
    """

    heartbeat_lost_s: Annotated[
        float, Number("Silence of the console after which the vehicle acts; 0: never", "s", 0.0, 3600.0)
    ] = 0.0
    heartbeat_lost: Annotated[Reaction, does("the console is silent for so long in a mission")] = "hold"
    holder_lost_s: Annotated[
        float,
        Number(
            "Time without anybody in control after which the vehicle acts; 0: never",
            "s",
            0.0,
            3600.0,
            help="Control is lost when the holder's page is closed or cut off. Leave time for a page that is "
            "loaded anew; after ten seconds another browser that is open takes over.",
        ),
    ] = 0.0
    holder_lost: Annotated[Reaction, does("nobody has been in control for so long in a mission")] = "hold"
    target_missing_s: Annotated[float, limit("Longest time in a mission without the target", "s", 1e5)] = 0.0
    target_missing: Annotated[Reaction, does("the target was not seen for so long")] = "hold"
    depth_most_m: Annotated[float, limit("Deepest it may measure", "m", 11000.0)] = 0.0
    depth_exceeded: Annotated[Reaction, does("it measures more depth")] = "surface"
    distance_most_m: Annotated[
        float, limit("Farthest from the origin of the mission's frame, horizontally", "m", 1e6)
    ] = 0.0
    boundary_exceeded: Annotated[
        Reaction, does("it is farther away, or leaves the mission's keep-in boundary")
    ] = "hold"
    leak: Annotated[Reaction, does("it reports water inside")] = "surface"
    battery_least: Annotated[float, limit("Least charge, a share", "", 1.0)] = 0.0
    battery_low: Annotated[Reaction, does("its battery holds less")] = "surface"
    actuator_fault: Annotated[Reaction, does("the autopilot diagnoses a fault of an actuator")] = "none"
    not_finite: Annotated[
        Literal["abort", "none"], does("its estimated state or its commands are no numbers any more")
    ] = "abort"
    clock_jump_s: Annotated[float, limit("Largest jump of its clock", "s", 1e6)] = 0.0
    clock_jump: Annotated[Reaction, does("its clock jumps by more")] = "hold"
    after_crash: Annotated[
        Literal["hold", "surface", "abort"], does("its program comes back from a crash in flight")
    ] = "abort"

    def declared(self) -> tuple[Declared, ...]:
        """What happens when: every cause with its reaction, "none" where it is not watched."""
        return (
            _watched("heartbeat_lost", "The console is not heard during a mission.", self.heartbeat_lost,
                     self.heartbeat_lost_s, "s"),
            _watched("holder_lost", "Nobody is in control during a mission, as when your page is closed or "
                     "cut off.", self.holder_lost, self.holder_lost_s, "s"),
            _watched("target_missing", "The target is not seen for too long in a mission.",
                     self.target_missing, self.target_missing_s, "s"),
            _watched("depth_exceeded", "It is too deep.", self.depth_exceeded, self.depth_most_m, "m"),
            _watched("boundary_exceeded", "It is too far from the mission's origin.",
                     self.boundary_exceeded, self.distance_most_m, "m"),
            Declared("keep_in_left", "It leaves the mission's keep-in boundary.", self.boundary_exceeded),
            Declared("leak", "It reports a leak.", self.leak),
            _watched("battery_low", "Its battery runs low.", self.battery_low, self.battery_least, ""),
            Declared("actuator_fault", "It diagnoses a fault of an actuator.", self.actuator_fault),
            Declared("not_finite", "Its state or its commands are no numbers any more.", self.not_finite),
            _watched("clock_jump", "Its clock jumps.", self.clock_jump, self.clock_jump_s, "s"),
            Declared("after_crash", "Its program crashes in flight and comes back.", self.after_crash),
        )  # fmt: skip


def _watched(cause: str, when: str, reaction: Reaction, most: float, unit: str) -> Declared:
    return Declared(cause, when, reaction, most, unit) if most > 0.0 else Declared(cause, when, "none")
