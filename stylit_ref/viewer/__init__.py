"""A page that shows a grid of views from any place between them (Hauptfleisch 2020, 3.3 and 4.2).

What Python exports stands here; the page's own program is in ``src``, and built into ``bundle``.
"""
