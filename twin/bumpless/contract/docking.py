"""How the docking automaton's stages and reasons are named, wherever they are shown."""

from bumpless.contract import enums

STAGES: dict[int, str] = {
    enums.TRANSIT: "transit",
    enums.ENTRY: "way round",
    enums.APPROACH: "approach",
    enums.BACK: "backing off",
    enums.HOLD: "holding clear of the dock",
    enums.CREEP: "creeping into the dock",
    enums.CAPTURED: "captured",
}
REASONS: dict[int, str] = {
    enums.TARGET_LOST: "target lost",
    enums.OFF_LINE: "too far beside the approach line",
    enums.OFF_HEADING: "heading too far off the approach",
    enums.OFF_DEPTH: "depth too far off the target's",
    enums.OVERSHOT: "past the observation point",
    enums.STUCK_AT_GATE: "not fit to go on within the time allowed",
    enums.NOT_SEEN: "target not seen where it must be",
    enums.TOO_SLOW: "speed stays far from its reference, as with a fault",
    enums.CURRENT: "station can't be held in this current",
    enums.TIME_OVER: "time over",
    enums.FAILSAFE: "the vehicle's file asks for it",
}
