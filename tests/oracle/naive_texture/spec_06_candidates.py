"""6. Candidates."""

import numpy as np

from .spec_02_colours import distance
from .spec_03_exemplars import centres_of
from .spec_04_random_numbers import PATCHES, below, draw


def price(p, a, centre):
    """Price a candidate by how much S uses what is around it."""
    valid, half = a["valid"], p["radius"] // 2
    used = np.bincount(a["addresses"].ravel() % valid.size, minlength=valid.size)
    y, x = divmod(int(centre), valid.shape[1])
    around = np.s_[y - half : y + half + 1, x - half : x + half + 1]
    use = int(used.reshape(valid.shape)[around].sum())
    share = 256 * use * int(valid.sum()) // (int(valid[around].sum()) * a["addresses"].size)
    return (p["spread"] * share) >> 2


def candidate(p, a, centres, cell, attempt, y, x):
    """Choose the centre of a patch for a cell."""
    addresses, colours, radius = a["addresses"], a["colours"], p["radius"]
    height, width = addresses.shape
    stride, plane = a["valid"].shape[1], a["valid"].size
    best, least = None, None
    for k in range(p["prescreened"]):
        number = attempt * p["prescreened"] + k
        words = draw(p["seed"], PATCHES, p["iteration"], cell, number)
        chosen = centres[below(words[0], len(centres))]
        if words[1] % 65536 < p["coherence"]:
            v, u = (below(word, 2 * radius + 1) - radius for word in words[2:])
            there = int(addresses[(y + v) % height, (x + u) % width]) % plane - v * stride - u
            if there in set(centres):
                chosen = there
        if p["prescreened"] == 1:
            return chosen
        total = price(p, a, chosen)
        for v, u in a["ring"].tolist():
            shown = colours[addresses[(y + v) % height, (x + u) % width]]
            total += min(distance(int(colours[chosen + v * stride + u]), int(shown)), 20000)
            if p.get("guide_weight"):
                wanted = int(a["guide"][(y + v) % height, (x + u) % width])
                given = int(a["guide_colours"][chosen + v * stride + u])
                total += (distance(given, wanted) * p["guide_weight"]) >> 8
        if least is None or total < least:
            best, least = chosen, total
    return best


def stage_candidates(p, a):
    """Do stage candidates."""
    centres = centres_of(a["valid"], p["radius"])
    cells = enumerate(a["cells"].tolist())
    return {
        "candidates": [candidate(p, a, centres, cell, p["attempt"], y, x) for cell, (y, x) in cells]
    }


STAGES = {"candidates": stage_candidates}
