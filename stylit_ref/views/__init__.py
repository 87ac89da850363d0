"""Coherent stylization of views and sequences (Hauptfleisch 2020, chapters 2.4, 3.1 and 3.2)."""
