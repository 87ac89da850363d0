"""8. Frames."""

from .spec_05_shifting import all_shifted, fetched
from .spec_06_votes import searched, voted
from .spec_07_mixing import mixed


def stage_frame(p, a):
    """Do stage frame."""
    radius, style = p["patch_width"] // 2, a["style"]
    places, masked = all_shifted(a)
    frames, weights = [], []
    for first, weight in enumerate(p["weights"]):
        if weight == 0:
            continue
        order = [first, *(k for k in range(len(places)) if k != first)]
        candidates, nnf = fetched(a["nnfs"][order], places[order], masked[order])
        nnf = searched(style, nnf, candidates, voted(style, nnf, radius), radius)
        frames.append(voted(style, nnf, radius))
        weights.append(weight)
    return {"picture": mixed(frames, weights)}


STAGES = {"frame": stage_frame}
