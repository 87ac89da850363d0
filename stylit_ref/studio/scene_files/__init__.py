"""Scenes of files: which layers there are to pick from, and those that are picked, read."""
