"""Plant and control software in one closed loop."""
