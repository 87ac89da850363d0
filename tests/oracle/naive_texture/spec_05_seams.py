"""5. Seams."""

import numpy as np

from .spec_02_colours import distance


def seam(colours, a, b, step, eta, exponent):
    """Cost M of the seam between a and b, whose neighbours lie ``step`` further."""
    here, after, there, before = (int(colours[k]) for k in (a, a + step, b, b - step))
    q = np.float32(distance(here, before) + distance(there, after)) / np.float32(
        eta + distance(here, after) + distance(there, before)
    )
    power = np.float32(1) * q
    for _ in range(exponent - 1):
        power = np.float32(power * q)
    return int(min(np.float32(power * np.float32(256)), np.float32(2**24)))


def seams(addresses, colours, stride, eta, exponent):
    """Count the costs of all edges to the right and below."""
    height, width = addresses.shape
    seams_x, seams_y = (np.zeros((height, width), int) for _ in range(2))
    for y, x in np.ndindex(height, width):
        here = addresses[y, x]
        right, below = addresses[y, (x + 1) % width], addresses[(y + 1) % height, x]
        seams_x[y, x] = seam(colours, here, right, 1, eta, exponent)
        seams_y[y, x] = seam(colours, here, below, stride, eta, exponent)
    return seams_x, seams_y


def guide_cost(shown, wanted, weight):
    """Cost of a pixel by its guide."""
    return (distance(int(shown), int(wanted)) * weight) >> 16


def guide_costs(addresses, guide_colours, guide, weight):
    """Cost of all pixels by their guides."""
    costs = np.zeros(addresses.shape, int)
    for y, x in np.ndindex(addresses.shape):
        costs[y, x] = guide_cost(guide_colours[addresses[y, x]], guide[y, x], weight)
    return costs


def stage_seams(p, a):
    """Do stage seams."""
    given = a["addresses"], a["colours"], p["stride"], p["eta"], p["exponent"]
    seams_x, seams_y = seams(*given)
    return {"seams_x": seams_x, "seams_y": seams_y}


def stage_guide_costs(p, a):
    """Do stage guide_costs."""
    given = a["addresses"], a["guide_colours"], a["guide"], p["guide_weight"]
    return {"costs": guide_costs(*given)}


STAGES = {"seams": stage_seams, "guide_costs": stage_guide_costs}
