"""The painting on the disk: saved as it grows, and read again when another program changes it."""
