"""The docking automaton and the references that go with it. Beyond the paper.

Modes stay F, R and H of eq. (53); what a mode is used for is the stage (`stages`): transit along the legs,
the way round to the approach line (entry), the approach with its gates, the way back, and holding station
once all is over. A vehicle without sway holds station only with its bow near the current, so the approach
heading is a choice inside the target's tolerance, made from the estimated current (`heading`). One law serves
the approach in F, R and H and the way back (`line`), so that a switch moves no reference.

With `docking.enabled` off none of it is used: the published automaton and guidance fly.
"""
