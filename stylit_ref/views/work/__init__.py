"""The work of coherent frames: where states are made and kept, and who makes which."""
