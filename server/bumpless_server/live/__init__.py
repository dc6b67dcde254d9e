"""One vehicle as it is now: bus, state, stream to browsers."""
