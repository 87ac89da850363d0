"""Scenes, render passes and style exemplars. Apart from the library."""
