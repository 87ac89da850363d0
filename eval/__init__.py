"""Evaluation: scenes, runs, metrics and reports. It works from a checkout only."""
