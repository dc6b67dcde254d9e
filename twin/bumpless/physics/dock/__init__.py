"""A dock to enter: a funnel with a tube behind it, and what it does to a hull that touches it."""
