"""Runs and their numbers: what is computed once is not computed again."""
