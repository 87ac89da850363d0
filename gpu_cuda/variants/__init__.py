"""Other ways to run the same passes, kept for comparison of times."""
