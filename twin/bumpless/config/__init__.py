"""What people write: vehicles, missions, parameters. Each number is checked where it is read."""
