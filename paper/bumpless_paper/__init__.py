"""Gao et al. 2026 flown again: scenarios, study, report. `bumpless reproduce` is its command."""
