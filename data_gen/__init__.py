"""Scenes, render passes and style exemplars. Runs from the checkout, apart from the library."""
