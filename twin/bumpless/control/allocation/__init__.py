"""Control allocation: a demanded wrench becomes actuator commands."""
