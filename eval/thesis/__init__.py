"""The thesis' tables, figures and claims, on our scenes and beside the published numbers."""
