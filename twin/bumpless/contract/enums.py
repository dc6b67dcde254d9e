"""The contract's enumerations as plain numbers: compiled code and the records count as the bus does.

`tests/infra/test_enums.py` holds them against `bumpless.proto`.
"""

FORWARD, REVERSE, HOVER = 1, 2, 3  # Mode
MODES = (FORWARD, REVERSE, HOVER)

IDLE, RUNNING, PAUSED, COMPLETED, ABORTED = 1, 2, 3, 4, 5  # MissionPhase
FLYING = (RUNNING, PAUSED)  # a mission is being flown
ENDED = (COMPLETED, ABORTED)
MOVING = (RUNNING, PAUSED, COMPLETED)  # an actuator may move: after its mission a vehicle holds station

# SolveStatus, of a QP as of a cycle's allocation: optimal within tolerance; feasible, but not shown to be
# optimal; bounds contradict each other, the nearest point is held; the chosen solver failed, the built-in
# active set answered; not a number among the data, the start is held inside its bounds
SOLVED, BUDGET_SPENT, INFEASIBLE, FALLBACK, REFUSED = 1, 2, 3, 4, 5

INFO, WARNING, ALARM = 1, 2, 3  # Severity

# DockingStage; 0 where the published automaton flies
TRANSIT, ENTRY, APPROACH, BACK, HOLD, CREEP, CAPTURED = 1, 2, 3, 4, 5, 6, 7
WAVED_OFF_STAGES = (BACK, HOLD)  # on the way back from the dock, and holding clear of it for good

# WaveOffReason; 0 before the first wave-off
TARGET_LOST, OFF_LINE, OFF_HEADING, OFF_DEPTH, OVERSHOT = 1, 2, 3, 4, 5
STUCK_AT_GATE, NOT_SEEN, TOO_SLOW, CURRENT, TIME_OVER, FAILSAFE = 6, 7, 8, 9, 10, 11
