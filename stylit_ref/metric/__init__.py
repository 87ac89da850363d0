"""The metric in memory, and exact shortcuts that make it fast."""
