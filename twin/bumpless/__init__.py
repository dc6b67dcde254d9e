"""The Bumpless twin: vehicle, plant, sensors and the true control software, without web or files."""
