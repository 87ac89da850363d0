"""How the metric is laid out in memory, and the exact savings that make it fast."""
