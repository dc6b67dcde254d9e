"""What a draft of parameters would do to a vehicle that flies: flown ahead in a process of its own."""
