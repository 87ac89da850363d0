"""The page, its socket, and who may use them: on this machine, by whoever has the token."""
