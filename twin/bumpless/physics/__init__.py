"""What is true: water, hull, actuators, sensors. Knows nothing of control."""
