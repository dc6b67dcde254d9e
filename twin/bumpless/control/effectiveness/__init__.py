"""How much each actuator still gives, estimated while flying from what the vehicle measures.

`step.estimate_effectiveness` advances an ESTIMATOR record by one cycle. Its parts: `baseline` predicts the
momentum with the nominal model and learns what that leaves unexplained; `hypotheses` asks which actuator's
loss would explain the rest best.
"""
