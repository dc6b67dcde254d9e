"""Keys for the bus: a small certificate authority, who may say what, and each party's Zenoh configuration."""
