"""Parallel patch-based texture synthesis (Lasram & Lefebvre 2012)."""
