"""The paper's study, flown again: scenarios, figures, tables, ablation, goals, and how robust they are.

Everything here is a pure function of its arguments and gives plain values fit for JSON. Start at
`tables` (tables 6 to 8), `ablation` and `robustness`.
"""
