"""15. StyLit's search."""

import numpy as np

from .spec_01_names import assigned_pixels, clamp_to_centres, occurrence, radius_of, target_grid
from .spec_03_metric import delta, patch_delta
from .spec_04_random_numbers import CLAIM_SEARCH, RANDOM_CLAIMS, below, draw_grid, make_stream
from .spec_08_random_search import draw_between
from .spec_10_iteration import patchmatch_iteration
from .spec_14_error_budget import budget

NO_LIMIT = np.iinfo(np.int64).max


def source_centres(source_shape, radius):
    """Give the centre of every source patch, in the grid of the claims."""
    height, width = source_shape[0] - 2 * radius, source_shape[1] - 2 * radius
    return np.stack(target_grid(height, width), axis=-1) + radius


def error_limits(delta_values, error_limit):
    """Give the largest error every target pixel accepts."""
    if error_limit is None:
        return np.full(delta_values.shape, NO_LIMIT)
    limits = delta_values.astype(np.float64) * float(error_limit)
    return np.floor(np.minimum(limits, 2.0**62)).astype(np.int64)


def random_claims(grid_shape, target_shape, seed, level, vote_number):
    """Let every source patch claim a random target pixel."""
    words = draw_grid(make_stream(RANDOM_CLAIMS, seed, level, vote_number), *grid_shape, 0)
    y = below(words[..., 0], target_shape[0])
    x = below(words[..., 1], target_shape[1])
    return np.stack([y, x], axis=-1)


def invert_nnf(nnf, delta_values, claims, errors, radius):
    """Offer the target pixels, in rows, to the source patches they are assigned to."""
    claims, errors = claims.copy(), errors.copy()
    for y, x in np.argwhere(assigned_pixels(nnf)):
        patch = tuple(nnf[y, x] - radius)
        if delta_values[y, x] < errors[patch]:
            claims[patch] = y, x
            errors[patch] = delta_values[y, x]
    return claims, errors


class ClaimProposal:
    """The best claim so far of every source patch: its target pixel and error."""

    def __init__(self, claims, errors, fixed, measure):
        """Begin with the claims."""
        self.claims = claims.copy()
        self.errors = errors.copy()
        self.fixed = fixed
        self.measure = measure

    def offer(self, candidate, valid):
        """Replace the best where the candidate's pair (fixed, error) is lower."""
        errors = self.measure(candidate)
        fixed_old = self.fixed[self.claims[..., 0], self.claims[..., 1]]
        fixed_new = self.fixed[candidate[..., 0], candidate[..., 1]]
        lower = (fixed_new < fixed_old) | ((fixed_new == fixed_old) & (errors < self.errors))
        better = valid & lower
        self.claims = np.where(better[..., None], candidate, self.claims)
        self.errors = np.where(better, errors, self.errors)


def claim_propagation(claims, errors, fixed, measure, distance):
    """Take what the four neighbours at a distance suggest to the source patches."""
    height, width = errors.shape
    ys, xs = target_grid(height, width)
    best = ClaimProposal(claims, errors, fixed, measure)
    for dy, dx in ((0, distance), (distance, 0), (0, -distance), (-distance, 0)):
        y, x = ys + dy, xs + dx
        inside = (y >= 0) & (y < height) & (x >= 0) & (x < width)
        neighbour = claims[np.clip(y, 0, height - 1), np.clip(x, 0, width - 1)]
        best.offer(clamp_to_centres(neighbour - np.array([dy, dx]), fixed.shape, 0), inside)
    return best.claims, best.errors


def claim_search(claims, errors, fixed, measure, stream):
    """Take random target pixels around the claim, at growing distances."""
    best = ClaimProposal(claims, errors, fixed, measure)
    k = 0
    while 2**k <= max(fixed.shape) // 2:
        words = draw_grid(stream, *errors.shape, k // 2)
        first = 0 if k % 2 == 0 else 2
        y = draw_between(words[..., first], claims[..., 0], 2**k, 0, fixed.shape[0])
        x = draw_between(words[..., first + 1], claims[..., 1], 2**k, 0, fixed.shape[1])
        best.offer(np.stack([y, x], axis=-1), np.ones(errors.shape, bool))
        k += 1
    return best.claims, best.errors


def improve_claims(claims, errors, fixed, measure, stream):
    """Propagate the claims at 4, 2 and 1 and search at random, each result taken at once."""
    for distance in (4, 2, 1):
        claims, errors = claim_propagation(claims, errors, fixed, measure, distance)
    return claim_search(claims, errors, fixed, measure, stream)


def spend_budget(claims, errors, fixed, share):
    """Give last_error and last_claims; nothing where all claimed pixels are fixed."""
    free = np.sort(errors[~fixed[claims[..., 0], claims[..., 1]]])
    if free.size == 0:
        return None
    kept = free[: budget(free, share)]
    return kept[-1], int((kept == kept[-1]).sum())


def settle(claims, errors, fixed, limits, nnf, delta_values, radius, last_error, last_claims):
    """Let the target pixels take source patches; tell which took one."""
    nnf, delta_values = nnf.copy(), delta_values.copy()
    claimed = np.zeros(fixed.shape, bool)
    for place in np.ndindex(errors.shape):
        pixel, error = tuple(claims[place]), errors[place]
        if fixed[pixel] or error > last_error:
            continue
        if error == last_error:
            if last_claims == 0:
                continue
            last_claims -= 1
        if error > limits[pixel]:
            continue
        if not claimed[pixel] or error < delta_values[pixel]:
            nnf[pixel] = np.array(place) + radius
            delta_values[pixel] = error
            claimed[pixel] = True
    return nnf, delta_values, claimed


def stylit_search(source, target, weights, nnf, delta_values, radius, iterations, stylit,
                  seed, level, vote_number):  # fmt: skip
    """Search from target to source, then retrieve; count what each retrieval fixed."""
    share, fixed_share, error_limit = stylit
    source_shape, target_shape = source.shape[:2], target.shape[:2]

    def measure(centres):
        return delta(source, target, weights, centres, radius)

    def measure_claims(claims):
        return patch_delta(source, target, weights, claims, patches, radius)

    _, omega_sums = occurrence(nnf, source_shape, radius)
    for iteration in range(1, iterations + 1):
        nnf, delta_values, omega_sums = patchmatch_iteration(
            nnf, delta_values, omega_sums, 0, radius, measure, seed, level, vote_number, iteration
        )
    limits = error_limits(delta_values, error_limit)
    taking_part = assigned_pixels(nnf)
    fixed = ~taking_part

    patches = source_centres(source_shape, radius)
    grid_shape = patches.shape[:2]
    claims = random_claims(grid_shape, target_shape, seed, level, vote_number)
    errors = measure_claims(claims)
    claims, errors = invert_nnf(nnf, delta_values, claims, errors, radius)

    target_patches = int(taking_part.sum())
    enough = 0.001 * float(min(target_patches, grid_shape[0] * grid_shape[1]))
    counts = []
    k = 0
    while True:
        for iteration in range(iterations * k + 1, iterations * (k + 1) + 1):
            stream = make_stream(CLAIM_SEARCH, seed, level, vote_number, iteration)
            claims, errors = improve_claims(claims, errors, fixed, measure_claims, stream)
        claimed = np.zeros(target_shape, bool)
        spent = spend_budget(claims, errors, fixed, share)
        if spent is not None:
            nnf, delta_values, claimed = settle(
                claims, errors, fixed, limits, nnf, delta_values, radius, *spent
            )
        fixed = fixed | claimed
        counts.append(int(claimed.sum()))
        few = int((fixed & taking_part).sum()) < float(fixed_share) * float(target_patches)
        if not (few and counts[-1] >= enough and iterations * (k + 2) < 65536):
            return nnf, delta_values, counts
        k += 1


def stylit_of(p):
    """List the parameters of StyLit's search."""
    return p["budget"], p["fixed_share"], p["error_limit"]


def stage_invert_nnf(p, a):
    """Do stage invert_nnf."""
    claims, errors = invert_nnf(a["nnf"], a["delta"], a["claims"], a["errors"], radius_of(p))
    return {"claims": claims, "errors": errors}


def stage_settle(p, a):
    """Do stage settle."""
    nnf, delta_values, claimed = settle(
        a["claims"], a["errors"], a["fixed"], a["limits"], a["nnf"], a["delta"], radius_of(p),
        p["last_error"], p["last_claims"],
    )  # fmt: skip
    return {"nnf": nnf, "delta": delta_values, "claimed": claimed}


def stage_stylit_search(p, a):
    """Do stage stylit_search."""
    nnf, delta_values, counts = stylit_search(
        a["source"], a["target"], a["weights"], a["nnf"], a["delta"], radius_of(p),
        p["iterations"], stylit_of(p), int(p["seed"]), p["level"], p["vote"],
    )  # fmt: skip
    return {"nnf": nnf, "delta": delta_values, "fixed_counts": counts}


STAGES = {
    "invert_nnf": stage_invert_nnf,
    "settle": stage_settle,
    "stylit_search": stage_stylit_search,
}
