"""Views between those of a grid, from what the grid's views are made of (Hauptfleisch 2020, 3.3)."""
