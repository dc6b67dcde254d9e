"""The order of rows: wrench components, controlled errors, axes."""

from bumpless.contract.units import WRENCH as WRENCH  # in body axes about O_b

ERRORS = ("u", "v", "z", "phi", "theta", "psi")  # e of the PID
NED = ("north", "east", "down")
BODY = ("x", "y", "z")
MODES = ("forward", "reverse", "hover")  # the place of each is its number in the compiled world
