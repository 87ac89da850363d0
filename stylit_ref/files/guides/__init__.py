"""Guides: the values of source and targets become 8 bits in the same way."""
