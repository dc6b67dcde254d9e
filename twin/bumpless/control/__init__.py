"""The control software that flies, on the twin as on a vehicle: measurements in, commands out."""
