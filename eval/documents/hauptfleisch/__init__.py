"""Chapters 2.4 and 3.1 to 3.2 of Hauptfleisch (2020): buildings, grids of views and animations."""
