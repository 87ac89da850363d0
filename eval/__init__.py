"""Evaluation harness: scenes, runs, metrics, reports. Runs from the checkout."""
