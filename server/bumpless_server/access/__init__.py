"""People, scripts and what they may do: accounts, sessions, tokens, roles, and who holds control."""
