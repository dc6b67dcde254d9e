"""The 3-D scene: viser behind our own origin, drawn from the vehicle's own messages."""
