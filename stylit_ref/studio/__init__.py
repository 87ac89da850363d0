"""A page to paint on, beside the picture that follows."""
