"""Views between those of a grid, from what its views are made of (Hauptfleisch 2020, 3.3)."""
