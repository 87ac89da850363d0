"""7. Propagation."""

import numpy as np

from .spec_01_names import assigned_pixels, clamp_to_centres, radius_of, target_grid
from .spec_03_metric import delta, phi


class Proposal:
    """The best so far of every pixel: its centre, delta and phi."""

    def __init__(self, nnf, delta_values, omega_sums, occurrence_weight, measure):
        """Begin with the assignments."""
        self.nnf = nnf.copy()
        self.delta = delta_values.copy()
        self.omega_sums = omega_sums
        self.occurrence_weight = occurrence_weight
        self.measure = measure
        self.phi = phi(self.delta, omega_sums, occurrence_weight, nnf)

    def offer(self, candidate, valid):
        """Replace the best where the candidate's phi is lower."""
        candidate_delta = self.measure(candidate)
        candidate_phi = phi(candidate_delta, self.omega_sums, self.occurrence_weight, candidate)
        better = valid & (candidate_phi < self.phi)
        self.nnf = np.where(better[..., None], candidate, self.nnf)
        self.delta = np.where(better, candidate_delta, self.delta)
        self.phi = np.where(better, candidate_phi, self.phi)


def propagation(nnf, delta_values, omega_sums, occurrence_weight, radius, measure, distance):
    """Propose what the four neighbours at a distance suggest."""
    height, width = nnf.shape[:2]
    ys, xs = target_grid(height, width)
    assigned = assigned_pixels(nnf)
    best = Proposal(nnf, delta_values, omega_sums, occurrence_weight, measure)
    for dy, dx in ((0, distance), (distance, 0), (0, -distance), (-distance, 0)):
        y, x = ys + dy, xs + dx
        inside = (y >= 0) & (y < height) & (x >= 0) & (x < width)
        y, x = np.clip(y, 0, height - 1), np.clip(x, 0, width - 1)
        valid = assigned & inside & assigned[y, x]
        candidate = nnf[y, x] - np.array([dy, dx])
        candidate = clamp_to_centres(candidate, omega_sums.shape, radius)
        best.offer(candidate, valid)
    return best.nnf, best.delta


def pass_arguments(p, a):
    """List what propagation, random search and an iteration have in common."""

    def measure(centres):
        return delta(a["source"], a["target"], a["weights"], centres, radius_of(p))

    weight = p["occurrence_weight"]
    return a["nnf"], a["delta"], a["omega_sums"], weight, radius_of(p), measure


def stage_propagation(p, a):
    """Do stage propagation."""
    proposed_nnf, proposed_delta = propagation(*pass_arguments(p, a), p["distance"])
    return {"proposed_nnf": proposed_nnf, "proposed_delta": proposed_delta}


STAGES = {"propagation": stage_propagation}
