"""Image files in and out, and how many bits their values have."""
