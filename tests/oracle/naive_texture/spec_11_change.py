"""11. The exact change."""

from .spec_01_names import offset_of
from .spec_05_seams import guide_costs, seam, seams


def cost_of(p, a, addresses):
    """Count the cost of a texture."""
    stride = a["valid"].shape[1]
    total = sum(part.sum() for part in seams(addresses, a["colours"], stride, *_numbers(p)))
    if p["guide_weight"]:
        total += guide_costs(addresses, a["guide_colours"], a["guide"], p["guide_weight"]).sum()
    return int(total)


def _numbers(p):
    return p["eta"], p["exponent"]


def written(p, addresses, patch, y, x):
    """Give the texture with a patch written."""
    after = addresses.copy()
    height, width = addresses.shape
    for place, address in enumerate(patch):
        if address >= 0:
            dy, dx = offset_of(place, p["radius"])
            after[(y + dy) % height, (x + dx) % width] = address
    return after


def change(p, a, patch, y, x):
    """Count by how much a patch changes the cost of S."""
    after = written(p, a["addresses"], patch, y, x)
    return cost_of(p, a, after) - cost_of(p, a, a["addresses"])


def inner(p, a, patch):
    """Count the cost of the edges within a patch."""
    side, stride = 2 * p["radius"] + 5, a["valid"].shape[1]
    total = 0
    for place, here in enumerate(patch):
        for other, step in ((place + 1, 1), (place + side, stride)):
            if here >= 0 and other < len(patch) and patch[other] >= 0:
                total += seam(a["colours"], here, patch[other], step, *_numbers(p))
    return total


def stage_change(p, a):
    """Do stage change."""
    patch = a["patch"].tolist()
    after = written(p, a["addresses"], patch, p["y"], p["x"])
    seams_x, seams_y = seams(after, a["colours"], a["valid"].shape[1], *_numbers(p))
    return {
        "change": change(p, a, patch, p["y"], p["x"]),
        "inner": inner(p, a, patch),
        "addresses": after,
        "seams_x": seams_x,
        "seams_y": seams_y,
    }


STAGES = {"change": stage_change}
