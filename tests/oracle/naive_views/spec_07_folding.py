"""7. Folding."""

from math import floor, sqrt

import numpy as np
from naive_port.spec_02_weights import channel_weights

from .spec_01_names import ONE, in_units, pixels


def folded(own, guides, weights):
    """Fold the guides of neighbours into the frame's own picture: M and the spread."""
    everything = ONE + sum(weights)
    mixed, spread = np.empty_like(own), np.empty((*own.shape[:2], 1), own.dtype)
    for pixel in pixels(own.shape[:2]):
        deviation = 0
        for c in range(own.shape[2]):
            values = [int(own[pixel][c]), *(int(guide[pixel][c]) for guide in guides)]
            pairs = list(zip([ONE, *weights], values, strict=True))
            total = sum(weight * value for weight, value in pairs)
            squares = sum(weight * value**2 for weight, value in pairs)
            mixed[pixel][c] = (2 * total + everything) // (2 * everything)
            deviation += everything * squares - total**2
        variance = float(deviation) / float(everything**2)
        spread[pixel] = floor(sqrt(variance) + 0.5)
    return mixed, spread


def coherent_weights(p, style_channels, neighbours, with_spread):
    """Give the weights of a frame that neighbours pull at."""
    weights = channel_weights(
        p["guide_channels"], p["guide_weights"], style_channels, p["guide_influence"]
    )
    factor = ONE
    if p["form"] == "plain":
        factor += neighbours * in_units(p["coherence"])
    guides, style = np.split(weights, [sum(p["guide_channels"])])
    style = (style * factor + 128) // 256
    return np.concatenate([guides, style[:1] if with_spread else [], style]).astype(np.int64)


def stage_fold(p, a):
    """Do stage fold."""
    mixed, spread = folded(a["own"], a["guides"], a["weights"].tolist())
    return {"mixed": mixed, "spreads": spread}


def stage_weights(p, a):
    """Do stage weights."""
    weights = coherent_weights(p, p["style_channels"], p["neighbours"], p["spread"])
    return {"weights": weights}


STAGES = {"fold": stage_fold, "weights": stage_weights}
