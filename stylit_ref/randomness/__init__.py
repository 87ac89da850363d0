"""Random numbers: each draw has its own, whatever the order of computation."""
