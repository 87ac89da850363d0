"""What the studio computes: a picture that follows the painting, and what there is to look at."""
