"""What the docking automaton is set to, remembers and sees."""

import numpy as np

from bumpless.config.parameters.records import section_dtype

f8, i8 = np.float64, np.int64

DOCKING_SETTINGS = section_dtype("docking")

DOCKING_STATE = np.dtype(
    [
        ("stage", i8),  # DockingStage of the contract; 0: the published automaton flies
        ("stage_cycle", i8),  # at which the stage began
        ("tried", i8),  # approaches begun
        ("reason", i8),  # WaveOffReason of the last wave-off; 0: none yet
        ("heading", f8),  # approach heading in use, rad
        ("fix_age", i8),  # cycles since the last fix of the target
        ("side", i8),  # of the turn on to the approach line: 1 clockwise, -1 the other way
        ("farther", f8),  # how much sooner than entry_distance the line is joined, m
        (
            "passing",
            i8,
        ),  # side on which a dock beside a leg is passed: 1 to starboard, -1 to port; 0: none is
        ("cleared", i8),  # 1: the gate is passed
        ("gate_cycles", i8),  # spent waiting: at the gate, in H outside its limits, at the hold point
        ("still", i8),  # cycles in a row in place at the observation point, before a dock to enter
        ("back_to", f8),  # distance before the observation point where a way back ends, m
        ("drift", f8),  # sideways drift learnt beside the estimated current, m/s
        ("tilt", f8),  # sideways drift of a hull that rolls while its verticals push, smoothed, m/s
        ("lateral_rate", f8),  # speed over ground across the approach line, to starboard, smoothed, m/s
        ("surge_lag", f8),  # by how much speed stays behind its reference, smoothed, m/s
        ("made", f8),  # speed that the commands should have made of it, m/s
        ("braked", f8),  # of that, what thrust astern should have taken off it lately, m/s
        ("unbraked", f8),  # by how much the vehicle is faster than that, smoothed, m/s
        ("slip", f8),  # by how much a shaft stays behind its command, smoothed, rev/s
        ("stops", f8),  # way in which a vehicle waved off as too slow comes to rest, m
        ("u_dot", f8),  # of the speed reference, m/s^2
        ("turn", f8),  # rate of the heading reference under way, smoothed, rad/s
        ("leg_climb", f8),  # rate of the depth reference on a leg that slopes, smoothed, m/s
        ("pitch_share", f8),  # of depth control that pitch has
        ("schedule", f8),  # share of the fin channels' gains in the last cycle; 0 before the first
    ],
    align=True,
)

DOCKING_OUTPUT = np.dtype(  # where the vehicle is on the approach line in this cycle
    [
        ("left", f8),  # way left along the line to the observation point, m
        ("aside", f8),  # offset from the line, positive to starboard, m
        ("off", f8),  # |heading error|, rad
        ("room", f8),  # way of the nose to the dock's face, m
        ("deep", f8),  # |depth error| against the target, m
        ("age", f8),  # of the last fix, s
        ("detected", i8),  # chi
        ("depth_moves", i8),  # 1 while the depth reference moves
        ("schedule_fall", f8),  # factor by which the schedule fell in this cycle, at most 1
        ("lift", f8),  # of the fins that pitch the hull, added to the demand in heave, N
        ("asked", f8, 6),  # tau_d with that lift, N and N m
    ],
    align=True,
)
