"""7. Mixing."""

import numpy as np


def mixed(values, weights):
    """Give the mean of values by their weights."""
    total = sum(weight * value for weight, value in zip(weights, values, strict=True))
    return (2 * total + sum(weights)) // (2 * sum(weights))


def stage_mix(p, a):
    """Do stage mix."""
    return {"picture": mixed(list(a["pictures"]), [int(weight) for weight in a["weights"]])}


def stage_mix_shifted(p, a):
    """Do stage mix_shifted."""
    pictures, places, masked = a["pictures"], a["places"], a["masked"]
    picture = np.empty(pictures.shape[1:], np.int64)
    for y, x in np.ndindex(picture.shape[:2]):
        values = [pictures[k][tuple(places[k, y, x])] for k in range(len(places))]
        shown = [k for k in range(len(places)) if not masked[k, y, x]]
        weights = [int(a["weights"][k]) for k in shown]
        if sum(weights):
            picture[y, x] = mixed([values[k] for k in shown], weights)
        else:
            picture[y, x] = values[shown[0] if shown else 0]
    return {"picture": picture}


STAGES = {"mix": stage_mix, "mix_shifted": stage_mix_shifted}
