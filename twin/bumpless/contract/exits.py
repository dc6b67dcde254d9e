"""How processes end: whoever started one acts on the code."""

# a vehicle node: asked for; could not go on; the vehicle id is alive already
STOPPED, FAILED, TAKEN = 0, 1, 3

# `bumpless run`: flown (and ended as required); refused, or the log cannot be written; the command was used
# wrongly; the simulation broke down; flown, but its outcome is none of those that --require names
FLOWN, REFUSED, MISUSED, BROKEN, NOT_AS_REQUIRED = 0, 1, 2, 3, 4

# `bumpless compare --gate`: a limit was not kept
GATE_FAILED = 4
