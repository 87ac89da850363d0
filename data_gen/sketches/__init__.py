"""Architectural sketches, drawn over the render of a building.

Each does on purpose what a method that trusts its guides finds hard.
"""

from data_gen.sketches.building import building
from data_gen.sketches.hatched import hatched
from data_gen.sketches.inked import inked
from data_gen.sketches.marker import marker
from data_gen.sketches.two_walls import two_walls
from data_gen.sketches.unshadowed import unshadowed
from data_gen.sketches.washed import washed

SKETCHES = {
    "inked": inked,
    "hatched": hatched,
    "marker": marker,
    "two_walls": two_walls,
    "unshadowed": unshadowed,
    "washed": washed,
}

__all__ = ["SKETCHES", "building"]
