"""Make scenes, render passes and style exemplars; the library works without this package."""
