"""Colours: alpha, the depth of their values, and what a file says of them."""
