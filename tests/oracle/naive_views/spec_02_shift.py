"""2. Places and shifted pictures."""

from .spec_01_names import NOWHERE, Motion, pixels, places_of


def shifted(picture, places, own):
    """Make the guide of a neighbour."""
    guide = own.copy()
    for pixel in pixels(own.shape[:2]):
        place = tuple(places[pixel])
        if place != NOWHERE:
            guide[pixel] = picture[place]
    return guide


def stage_shift_map(p, a):
    """Do stage shift_map."""
    return {"places": places_of(Motion(a["field"], a["visible"]), p["depth"])}


def stage_shift_picture(p, a):
    """Do stage shift_picture."""
    return {"guide": shifted(a["picture"], a["places"], a["own"])}


STAGES = {"shift_map": stage_shift_map, "shift_picture": stage_shift_picture}
