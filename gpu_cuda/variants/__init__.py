"""Other ways to run the same passes, kept because they were measured."""
