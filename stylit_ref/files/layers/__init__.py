"""Layers of an image file: which there are, how one names them, and their pixels."""
