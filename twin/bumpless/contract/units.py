"""The edge: SI and radians inside, degrees and rpm in files, in messages and on the screen."""

from math import pi

DEG = 180.0 / pi  # degrees in a radian
RPM = 60.0  # revolutions per minute in one per second
EDGE_PER_SI = {"deg": DEG, "rpm": RPM}

WRENCH = ("X", "Y", "Z", "K", "M", "N")  # components in body axes about O_b
WRENCH_UNITS = ("N", "N", "N", "N·m", "N·m", "N·m")
