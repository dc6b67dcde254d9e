"""Missions of other programs, read into ours, and ours written for them, with what does not carry over."""
