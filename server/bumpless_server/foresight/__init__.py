"""Foresight: a mission is flown before it is flown, in processes of its own that give way to all others."""
