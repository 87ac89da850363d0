"""3. Vectors compared, and composed."""

from fractions import Fraction
from math import floor, isnan

import numpy as np

from .spec_01_names import NOWHERE, Motion, pixels, place_of, told


def fixed(component):
    """Give a component in units of 1/256."""
    component = float(component)
    if isnan(component):
        return 0
    if abs(component) > 2**18:
        return 2**26 if component > 0 else -(2**26)
    return floor(256 * Fraction(component) + Fraction(1, 2))


def fixed_vector(vector):
    """Give a vector in units of 1/256."""
    return fixed(vector[0]), fixed(vector[1])


def squared(vector):
    """Give the squared length."""
    return vector[0] ** 2 + vector[1] ** 2


def cancels(forth, back):
    """Tell whether two vectors cancel."""
    f, b = fixed_vector(forth), fixed_vector(back)
    away = squared((f[0] + b[0], f[1] + b[1]))
    return 100 * (away - 32768) <= squared(f) + squared(b)


def cancelling(motion, back):
    """Tell which pixels cancel."""
    found = np.zeros(motion.visible.shape, bool)
    for pixel in pixels(found.shape):
        place = place_of(motion, pixel)
        if place != NOWHERE and back.visible[place]:
            found[pixel] = cancels(motion.field[pixel], back.field[place])
    return found


def composed(first, second):
    """Follow one motion, then another."""
    field, visible = first.field.copy(), np.zeros(first.visible.shape, bool)
    for pixel in pixels(visible.shape):
        place = place_of(first, pixel)
        if place != NOWHERE and second.visible[place]:
            field[pixel] = first.field[pixel] + second.field[place]
            visible[pixel] = True
    return Motion(field, visible)


def differ(vector, other):
    """Tell whether two vectors differ."""
    ours, theirs = fixed_vector(vector), fixed_vector(other)
    return abs(ours[0] - theirs[0]) > 256 or abs(ours[1] - theirs[1]) > 256


def stage_cancel(p, a):
    """Do stage cancel."""
    forth, back = Motion(a["field"], a["visible"]), Motion(a["back"], a["known"])
    return {"cancels": cancelling(forth, back)}


def stage_compose(p, a):
    """Do stage compose."""
    second = Motion(a["next_field"], a["next_visible"])
    return told(composed(Motion(a["field"], a["visible"]), second))


STAGES = {"cancel": stage_cancel, "compose": stage_compose}
