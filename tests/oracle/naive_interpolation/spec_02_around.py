"""2. The views around a place."""

from math import floor


def sides(positions, place, band, is_ring):
    """Find both positions around a place, their distances, and their weights."""
    middle = positions[0] if is_ring else (positions[0] + positions[-1]) / 2
    at = place + middle
    after = list(positions)
    if is_ring:
        at = positions[0] + (at - positions[0]) % 360
        after.append(positions[0] + 360)
    if len(after) == 1:
        return [(0, (at - positions[0]) ** 2, 256, 256)]
    i = max([0, *(k for k in range(len(after) - 1) if at >= after[k])])
    low, high = after[i], after[i + 1]
    share = floor(256 * (at - low) / (high - low) + 1 / 2)
    if band * (high - low) == 0:
        fade = 256 if at > (low + high) / 2 else 0
    else:
        fade = floor(256 * (1 / 2 + (at - (low + high) / 2) / (band * (high - low))) + 1 / 2)
        fade = min(max(fade, 0), 256)
    return [
        (i, (at - low) ** 2, 256 - share, 256 - fade),
        ((i + 1) % len(positions), (at - high) ** 2, share, fade),
    ]


def stage_around(p, a):
    """Do stage around."""
    right, up = p["place"]
    found = [
        (across + above, row, column, x * y, x_fade * y_fade)
        for row, above, y, y_fade in sides(p["rows"], up, p["band"], False)
        for column, across, x, x_fade in sides(p["columns"], right, p["band"], p["is_ring"])
    ]
    found.sort()
    return {
        "views": [row * len(p["columns"]) + column for _, row, column, _, _ in found],
        "linear": [view[3] for view in found],
        "fading": [view[4] for view in found],
    }


STAGES = {"around": stage_around}
