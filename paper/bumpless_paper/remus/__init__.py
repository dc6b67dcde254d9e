"""REMUS as the thesis prints it, against what its geometry gives."""
