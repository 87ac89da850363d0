"""A naive port of the algorithm, written from SPEC.md (version 1) alone.

Usage: python naive_port.py INPUT_FOLDER OUTPUT_FOLDER
"""

import json
import math
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np

# --- 1. Names -----------------------------------------------------------------------------------
# Grids of pixels are int64 arrays inside; run_case gives the outputs their types.


def offsets(radius):
    """List (dy, dx) of a patch in rows."""
    span = range(-radius, radius + 1)
    return [(dy, dx) for dy in span for dx in span]


def assigned_pixels(nnf):
    """Tell which target pixels hold a source patch (are not at -1)."""
    return nnf[..., 0] >= 0


def target_grid(height, width):
    """Give the rows and columns of all pixels."""
    return np.meshgrid(np.arange(height), np.arange(width), indexing="ij")


def clamp_to_centres(nnf, source_shape, radius):
    """Clamp each coordinate to the centres of the source."""
    low = np.array([radius, radius])
    high = np.array([source_shape[0] - 1 - radius, source_shape[1] - 1 - radius])
    return np.minimum(np.maximum(nnf, low), high)


def box_sum(values, radius):
    """Sum the w x w pixels around each pixel; pixels outside count 0."""
    height, width = values.shape
    padded = np.pad(values, radius)
    total = np.zeros((height, width), np.int64)
    for dy, dx in offsets(radius):
        total += padded[radius + dy : radius + dy + height, radius + dx : radius + dx + width]
    return total


def patch_counts(nnf, source_shape):
    """Count the patches centred at each source pixel."""
    counts = np.zeros(source_shape, np.int64)
    centres = nnf[assigned_pixels(nnf)]
    np.add.at(counts, (centres[:, 0], centres[:, 1]), 1)
    return counts


def occurrence(nnf, source_shape, radius):
    """Count omega and W, its sums over patches."""
    omega = box_sum(patch_counts(nnf, source_shape), radius)
    return omega, box_sum(omega, radius)


# --- 2. Weights ---------------------------------------------------------------------------------


def channel_weights(guide_channels, guide_weights, style_channels, guide_influence):
    """Give each channel its fixed-point weight."""
    n_g = sum(guide_channels)
    if not guide_weights:
        guide_weights = [1] * len(guide_channels)
    weights = []
    for channels, guide_weight in zip(guide_channels, guide_weights, strict=True):
        for _ in range(channels):
            product = 65536.0 * (float(guide_influence) / n_g)
            weights.append(round(product * float(guide_weight)))
    weights += [round(65536.0 / style_channels)] * style_channels
    return np.array(weights, np.int64)


def occurrence_weight_of(uniformity, patch_width, source_pixels, target_patches):
    """Give the fixed-point weight of W."""
    area = patch_width * patch_width
    best = float(area * target_patches) / float(source_pixels)
    return round((65536.0 * float(uniformity)) / (float(area) * best))


# --- 3. The metric ------------------------------------------------------------------------------


def usable_centres(nnf, radius):
    """Replace -1 by some centre, so that whole grids can be measured; the result is masked."""
    return np.where(assigned_pixels(nnf)[..., None], nnf, radius)


def patch_values(source, target, pixels, centres, dy, dx):
    """Give the target's and the source's values at an offset in their patches."""
    height, width = target.shape[:2]
    y = np.clip(pixels[..., 0] + dy, 0, height - 1)
    x = np.clip(pixels[..., 1] + dx, 0, width - 1)
    source_values = source[centres[..., 0] + dy, centres[..., 1] + dx]
    return target[y, x].astype(np.int64), source_values.astype(np.int64)


def patch_delta(source, target, weights, pixels, centres, radius):
    """Compare the patches of target pixels and of source centres."""
    total = np.zeros(pixels.shape[:-1], np.int64)
    for dy, dx in offsets(radius):
        target_values, source_values = patch_values(source, target, pixels, centres, dy, dx)
        difference = target_values - source_values
        total += (weights * difference * difference).sum(axis=-1)
    return total


def delta(source, target, weights, nnf, radius):
    """Compare the patches of each target pixel and of its source centre; 0 at -1."""
    pixels = np.stack(target_grid(*nnf.shape[:2]), axis=-1)
    total = patch_delta(source, target, weights, pixels, usable_centres(nnf, radius), radius)
    return np.where(assigned_pixels(nnf), total, 0)


def penalty(omega_sums, occurrence_weight, nnf):
    """Give lambda rho of each assignment; of no meaning at -1."""
    return occurrence_weight * omega_sums[nnf[..., 0], nnf[..., 1]]


def phi(delta_values, omega_sums, occurrence_weight, nnf):
    """Add the penalty to delta; 0 at -1."""
    total = penalty(omega_sums, occurrence_weight, nnf) + delta_values
    return np.where(assigned_pixels(nnf), total, 0)


# --- 4. Random numbers --------------------------------------------------------------------------

WORD = 0xFFFFFFFF
RANDOM_NNF, RANDOM_SEARCH, COMMIT_ORDER, RANDOM_CLAIMS, CLAIM_SEARCH = 1, 2, 3, 4, 5


def philox(counters, keys):
    """Compute Philox4x32-10 of counters (n, 4) and keys (n, 2)."""
    c0, c1, c2, c3 = (counters[:, i].astype(np.uint64) for i in range(4))
    k0, k1 = (keys[:, i].astype(np.uint64) for i in range(2))
    low, shift = np.uint64(WORD), np.uint64(32)
    for _ in range(10):
        product0 = np.uint64(0xD2511F53) * c0
        product1 = np.uint64(0xCD9E8D57) * c2
        h0, l0 = product0 >> shift, product0 & low
        h1, l1 = product1 >> shift, product1 & low
        c0, c1, c2, c3 = h1 ^ c1 ^ k0, l1, h0 ^ c3 ^ k1, l0
        k0 = (k0 + np.uint64(0x9E3779B9)) & low
        k1 = (k1 + np.uint64(0xBB67AE85)) & low
    return np.stack([c0, c1, c2, c3], axis=1)


def make_stream(purpose, seed, level, vote=0, iteration=0):
    """Name a stream: (c2, c3, k0, k1)."""
    return vote << 16 | iteration, purpose << 16 | level, seed & WORD, (seed >> 32) & WORD


def draw_words(stream, positions, draw):
    """Draw the four words of each position."""
    c2, c3, k0, k1 = stream
    count = len(positions)
    counters = np.empty((count, 4), np.uint64)
    counters[:, 0] = positions
    counters[:, 1] = draw
    counters[:, 2] = c2
    counters[:, 3] = c3
    keys = np.empty((count, 2), np.uint64)
    keys[:, 0] = k0
    keys[:, 1] = k1
    return philox(counters, keys)


def draw_grid(stream, height, width, draw):
    """Draw the four words of each target pixel."""
    return draw_words(stream, np.arange(height * width), draw).reshape(height, width, 4)


def below(words, n):
    """Turn words into integers below n."""
    return ((words * np.asarray(n).astype(np.uint64)) >> np.uint64(32)).astype(np.int64)


# --- 5. Random NNF ------------------------------------------------------------------------------


def random_nnf(nnf, source_shape, radius, seed, level):
    """Assign a random centre to every pixel that is not at -1."""
    height, width = nnf.shape[:2]
    words = draw_grid(make_stream(RANDOM_NNF, seed, level), height, width, 0)
    y = radius + below(words[..., 0], source_shape[0] - 2 * radius)
    x = radius + below(words[..., 1], source_shape[1] - 2 * radius)
    return np.where(assigned_pixels(nnf)[..., None], np.stack([y, x], axis=-1), -1)


# --- 6. Pyramid ---------------------------------------------------------------------------------


def blocks(image):
    """List the four pixels of the 2 x 2 blocks; a last odd row or column is left out."""
    height, width = image.shape[0] // 2 * 2, image.shape[1] // 2 * 2
    return [image[i:height:2, j:width:2] for i in (0, 1) for j in (0, 1)]


def downsample(image):
    """Halve an image, rounding the mean of a block."""
    return (sum(block.astype(np.int64) for block in blocks(image)) + 2) // 4


def parts_of(mask, radius):
    """Tell which pixels of the finest level take part: those within r of an unmasked one."""
    return box_sum((~mask).astype(np.int64), radius) > 0


def coarser_part(part):
    """Tell which pixels of a coarser level take part: those any of whose children does."""
    height, width = part.shape[0] // 2, part.shape[1] // 2
    ys, xs = target_grid(*part.shape)
    coarser = np.zeros((height, width), bool)
    np.logical_or.at(
        coarser, (np.minimum(ys // 2, height - 1), np.minimum(xs // 2, width - 1)), part
    )
    return coarser


def level_count(levels, sides, patch_width):
    """Count the levels: the coarsest is halved once less than there are levels."""
    count = 1
    while count < levels and min(sides) >> count >= patch_width:
        count += 1
    return count


def pyramid(finest, count, halve):
    """List the levels, from the coarsest to the finest."""
    levels = [finest]
    while len(levels) < count:
        levels.append(halve(levels[-1]))
    return levels[::-1]


def upsample_nnf(coarse_nnf, nnf, source_shape, radius):
    """Take the NNF from the coarser level for every pixel that is not at -1."""
    coarse_height, coarse_width = coarse_nnf.shape[:2]
    ys, xs = target_grid(*nnf.shape[:2])
    parent_y = np.minimum(ys // 2, coarse_height - 1)
    parent_x = np.minimum(xs // 2, coarse_width - 1)
    remainder = np.stack([ys - 2 * parent_y, xs - 2 * parent_x], axis=-1)
    fine = 2 * coarse_nnf[parent_y, parent_x] + remainder
    fine = clamp_to_centres(fine, source_shape, radius)
    return np.where(assigned_pixels(nnf)[..., None], fine, -1)


# --- 7. Propagation -----------------------------------------------------------------------------


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


# --- 8. Random search ---------------------------------------------------------------------------


def draw_between(words, middle, reach, radius, side):
    """Draw a coordinate within reach of the middle and among the centres."""
    low = np.maximum(middle - reach, radius)
    high = np.minimum(middle + reach, side - 1 - radius)
    return low + below(words, high - low + 1)


def random_search(nnf, delta_values, omega_sums, occurrence_weight, radius, measure, stream):
    """Propose random centres around the assignment, at growing distances."""
    height, width = nnf.shape[:2]
    assigned = assigned_pixels(nnf)
    middle = usable_centres(nnf, radius)
    best = Proposal(nnf, delta_values, omega_sums, occurrence_weight, measure)
    k = 0
    while 2**k <= max(height, width) // 2:
        words = draw_grid(stream, height, width, k // 2)
        first = 0 if k % 2 == 0 else 2
        sides = omega_sums.shape
        y = draw_between(words[..., first], middle[..., 0], 2**k, radius, sides[0])
        x = draw_between(words[..., first + 1], middle[..., 1], 2**k, radius, sides[1])
        best.offer(np.stack([y, x], axis=-1), assigned)
        k += 1
    return best.nnf, best.delta


# --- 9. Commit ----------------------------------------------------------------------------------


def commit_order(stream):
    """Shuffle the 16 classes."""
    order = [(k // 4, k % 4) for k in range(16)]
    for last in range(15, 0, -1):
        pick = int(below(draw_words(stream, [last], 0)[0, 0], last + 1))
        order[last], order[pick] = order[pick], order[last]
    return order


def commit(nnf, delta_values, proposed_nnf, proposed_delta, omega_sums, occurrence_weight,
           radius, order):  # fmt: skip
    """Move pixels to their proposals, class after class; count the moves."""
    nnf, delta_values, omega_sums = nnf.copy(), delta_values.copy(), omega_sums.copy()
    ys, xs = target_grid(*nnf.shape[:2])
    moves = 0
    for class_y, class_x in order:
        in_class = (ys % 4 == class_y) & (xs % 4 == class_x) & assigned_pixels(nnf)
        differs = (proposed_nnf != nnf).any(axis=-1)
        phi_old = phi(delta_values, omega_sums, occurrence_weight, nnf)
        phi_new = phi(proposed_delta, omega_sums, occurrence_weight, proposed_nnf)
        moving = in_class & differs & (phi_new < phi_old)
        change = patch_counts(proposed_nnf[moving], omega_sums.shape)
        change -= patch_counts(nnf[moving], omega_sums.shape)
        omega_sums += box_sum(box_sum(change, radius), radius)
        nnf[moving] = proposed_nnf[moving]
        delta_values[moving] = proposed_delta[moving]
        moves += int(moving.sum())
    return nnf, delta_values, omega_sums, moves


# --- 10. One PatchMatch iteration ---------------------------------------------------------------


def patchmatch_iteration(nnf, delta_values, omega_sums, occurrence_weight, radius, measure,
                         seed, level, vote_number, iteration):  # fmt: skip
    """Propagate at 4, 2 and 1 and search at random, with a commit after each."""
    order = commit_order(make_stream(COMMIT_ORDER, seed, level, vote_number, iteration))
    search_stream = make_stream(RANDOM_SEARCH, seed, level, vote_number, iteration)
    for distance in (4, 2, 1, None):
        common = (nnf, delta_values, omega_sums, occurrence_weight, radius, measure)
        if distance is None:
            proposed_nnf, proposed_delta = random_search(*common, search_stream)
        else:
            proposed_nnf, proposed_delta = propagation(*common, distance)
        nnf, delta_values, omega_sums, _ = commit(
            nnf, delta_values, proposed_nnf, proposed_delta, omega_sums, occurrence_weight,
            radius, order,
        )  # fmt: skip
    return nnf, delta_values, omega_sums


# --- 11. Vote -----------------------------------------------------------------------------------


def gather_votes(style, nnf, radius):
    """List the votes every pixel hears, in rows of the patches: values and which are cast."""
    height, width = nnf.shape[:2]
    ys, xs = target_grid(height, width)
    values, cast = [], []
    for dy, dx in offsets(radius):
        y, x = ys + dy, xs + dx
        inside = (y >= 0) & (y < height) & (x >= 0) & (x < width)
        patch = nnf[np.clip(y, 0, height - 1), np.clip(x, 0, width - 1)]
        heard = inside & assigned_pixels(patch)
        pixel = np.where(heard[..., None], patch - np.array([dy, dx]), 0)
        values.append(style[pixel[..., 0], pixel[..., 1]].astype(np.int64))
        cast.append(heard)
    return np.stack(values), np.stack(cast)


def leave_out(values, cast, outliers):
    """Take away the votes farthest from the mean of all; one always stays."""
    n = cast.sum(axis=0)
    total = (values * cast[..., None]).sum(axis=0)
    distance = ((n[..., None] * values - total) ** 2).sum(axis=-1)
    ys, xs = target_grid(*n.shape)
    kept = cast.copy()
    for _ in range(outliers):
        farthest = np.where(kept, distance, -1).argmax(axis=0)  # the first of equals
        drop = kept.sum(axis=0) > 1
        kept[farthest[drop], ys[drop], xs[drop]] = False
    return kept


def vote(style, nnf, radius, outliers=0):
    """Give every pixel the mean of its votes, rounded half up; 0 without votes."""
    values, cast = gather_votes(style, nnf, radius)
    kept = leave_out(values, cast, outliers)
    n = kept.sum(axis=0)[..., None]
    total = (values * kept[..., None]).sum(axis=0)
    return np.where(n > 0, (2 * total + n) // np.maximum(2 * n, 1), 0)


# --- 12. Guide maps -----------------------------------------------------------------------------


def source_patch_sums(guides, radius):
    """Sum the source patches of each channel; 0 off the centres."""
    height, width = guides.shape[:2]
    sums = np.zeros(guides.shape, np.int64)
    inner = sums[radius : height - radius, radius : width - radius]
    for dy, dx in offsets(radius):
        inner += guides[
            radius + dy : height - radius + dy, radius + dx : width - radius + dx
        ].astype(np.int64)
    return sums


def target_patch_sums(guides, radius):
    """Sum the target patches of each channel, with clamped coordinates."""
    height, width = guides.shape[:2]
    ys, xs = target_grid(height, width)
    sums = np.zeros(guides.shape, np.int64)
    for dy, dx in offsets(radius):
        y, x = np.clip(ys + dy, 0, height - 1), np.clip(xs + dx, 0, width - 1)
        sums += guides[y, x].astype(np.int64)
    return sums


def guide_variances(target_guides, guide_weights, radius):
    """Give V, w to the fourth times the variance of every target patch."""
    area = (2 * radius + 1) ** 2
    values = target_guides.astype(np.int64)
    sums = target_patch_sums(values, radius)
    squares = target_patch_sums(values * values, radius)
    return (area * squares - sums * sums)[..., guide_weights != 0].sum(axis=-1)


def white_pixels(variances, epsilon, radius):
    """Tell which target pixels are white."""
    return variances < math.ceil(Fraction(epsilon) * (2 * radius + 1) ** 4)


def guide_map(source_guides, target_guides, guide_weights, radius, epsilon):
    """Make the sums of source and target, the variances and the white pixels."""
    variances = guide_variances(target_guides, guide_weights, radius)
    return (
        source_patch_sums(source_guides, radius),
        target_patch_sums(target_guides, radius),
        variances,
        white_pixels(variances, epsilon, radius),
    )


def white_delta(source, target, weights, nnf, radius, source_sums, target_sums, white):
    """Measure as in 3, but where white the guides by the sums of their patches."""
    n_g = source_sums.shape[-1]
    area = (2 * radius + 1) ** 2
    guides = delta(source[..., :n_g], target[..., :n_g], weights[:n_g], nnf, radius)
    style = delta(source[..., n_g:], target[..., n_g:], weights[n_g:], nnf, radius)
    centres = usable_centres(nnf, radius)
    difference = target_sums - source_sums[centres[..., 0], centres[..., 1]]
    white_guides = (weights[:n_g] * difference * difference).sum(axis=-1) // area
    total = np.where(white, white_guides, guides) + style
    return np.where(assigned_pixels(nnf), total, 0)


# --- 13. A level, and a run ---------------------------------------------------------------------


def run_level(source, target_guides, weights, nnf, radius, occurrence_weight, votes, iterations,
              seed, level, epsilon=None, stylit=None):  # fmt: skip
    """Synthesize one level; with an epsilon by guide maps, with stylit by the search of 15."""
    n_g = target_guides.shape[-1]
    style = source[..., n_g:]
    source_shape = source.shape[:2]
    maps = None
    if epsilon is not None:
        source_sums, target_sums, _, white = guide_map(
            source[..., :n_g], target_guides, weights[:n_g], radius, epsilon
        )
        maps = (source_sums, target_sums, white)
    _, omega_sums = occurrence(nnf, source_shape, radius)
    for vote_number in range(1, votes + 1):
        target = np.concatenate([target_guides, vote(style, nnf, radius)], axis=-1)

        def measure(centres, target=target):
            if maps is None:
                return delta(source, target, weights, centres, radius)
            return white_delta(source, target, weights, centres, radius, *maps)

        delta_values = measure(nnf)
        if stylit is not None:
            nnf, delta_values, _ = stylit_search(
                source, target, weights, nnf, delta_values, radius, iterations, stylit,
                seed, level, vote_number,
            )  # fmt: skip
            continue
        for iteration in range(1, iterations + 1):
            nnf, delta_values, omega_sums = patchmatch_iteration(
                nnf, delta_values, omega_sums, occurrence_weight, radius, measure,
                seed, level, vote_number, iteration,
            )  # fmt: skip
    omega, _ = occurrence(nnf, source_shape, radius)
    return vote(style, nnf, radius), nnf, omega


def empty_nnf(part):
    """Mark with 0 the pixels that take part; the others with -1."""
    return np.where(part[..., None], np.zeros(2, np.int64), -1)


def run(style, source_guides, target_guides, mask, p, stylit=None):
    """Go from the coarsest level to the finest."""
    patch_width = p["patch_width"]
    radius = patch_width // 2
    seed = int(p["seed"])
    epsilon = p["epsilon"] if p["method"] == "guide_map" else None
    weights = channel_weights(
        p["guide_channels"], p["guide_weights"], style.shape[-1], p["guide_influence"]
    )
    source = np.concatenate([source_guides, style], axis=-1)
    sides = source.shape[:2] + target_guides.shape[:2]
    count = level_count(p["levels"], sides, patch_width)
    sources = pyramid(source, count, downsample)
    targets = pyramid(target_guides, count, downsample)
    parts = pyramid(parts_of(mask, radius), count, coarser_part)
    image = nnf = omega = None
    for level in range(1, count + 1):
        level_source, part = sources[level - 1], parts[level - 1]
        source_shape = level_source.shape[:2]
        blank = empty_nnf(part)
        if level == 1:
            nnf = random_nnf(blank, source_shape, radius, seed, level)
        else:
            nnf = upsample_nnf(nnf, blank, source_shape, radius)
        occurrence_weight = occurrence_weight_of(
            p["uniformity"],
            patch_width,
            source_shape[0] * source_shape[1],
            int(assigned_pixels(nnf).sum()),
        )
        image, nnf, omega = run_level(
            level_source, targets[level - 1], weights, nnf, radius, occurrence_weight,
            p["votes"], p["iterations"], seed, level, epsilon, stylit,
        )  # fmt: skip
    return np.where(mask[..., None], 0, image), nnf, omega


# --- 14. Error budget of StyLit -----------------------------------------------------------------


def budget(errors, share):
    """Count the correspondences that a share of the error keeps."""
    total, sums = 0.0, []
    for error in errors:
        total += float(error)
        sums.append(total)
    limit = float(share) * total
    return max([1] + [k for k, running in enumerate(sums, start=1) if running <= limit])


def knee(a, b):
    """Find where the slope of 1 / (a - bx) over its value at 1 is 1."""
    with np.errstate(divide="ignore", invalid="ignore"):
        x = (a - np.sqrt(b * (a - b))) / b
    return np.where(a < 2.0 * (a - b), 1.0, x)


# --- 15. StyLit's search ------------------------------------------------------------------------

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


# --- 16. A lower bound of delta -----------------------------------------------------------------

MOMENTS = {
    3: ((1, 1, 1), (-1, 0, 1), (1, -2, 1)),
    5: ((1, 1, 1, 1, 1), (-2, -1, 0, 1, 2), (2, -1, -2, -1, 2)),
}
GUIDE_DEGREES = ((0, 0),)
STYLE_DEGREES = ((0, 0), (0, 1), (1, 0), (0, 2), (2, 0), (1, 1))


def channel_bound(source, target, weight, nnf, radius, degrees):
    """Bound the part of one channel by its moments."""
    inner = min(2 * radius + 1, 5)
    pixels = np.stack(target_grid(*nnf.shape[:2]), axis=-1)
    centres = usable_centres(nnf, radius)
    bound = np.zeros(nnf.shape[:2], np.int64)
    for v, h in degrees:
        p_v, p_h = MOMENTS[inner][v], MOMENTS[inner][h]
        difference, norm = 0, 0
        for dy, dx in offsets(inner // 2):
            factor = p_v[dy + inner // 2] * p_h[dx + inner // 2]
            ours, theirs = patch_values(source, target, pixels, centres, dy, dx)
            difference = difference + factor * (ours - theirs)
            norm += factor * factor
        bound += (8 * int(weight)) // norm * difference * difference
    return bound


def lower_bound(source, target, weights, nnf, radius, n_g):
    """Bound 8 delta of the assignments from below; 0 at -1."""
    total = np.zeros(nnf.shape[:2], np.int64)
    for c, weight in enumerate(weights):
        degrees = GUIDE_DEGREES if c < n_g else STYLE_DEGREES
        total += channel_bound(source[..., c], target[..., c], weight, nnf, radius, degrees)
    return np.where(assigned_pixels(nnf), total, 0)


# --- 17. Cases ----------------------------------------------------------------------------------


def radius_of(p):
    """Give the radius of the case's patches."""
    return p["patch_width"] // 2


def source_shape_of(p):
    """Give the size of a source that is known by its size only."""
    return p["source_height"], p["source_width"]


def stage_philox(p, a):
    """Stage of section 4."""
    return {"words": philox(a["counters"], a["keys"])}


def stage_weights(p, a):
    """Stage of section 2."""
    return {
        "weights": channel_weights(
            p["guide_channels"], p["guide_weights"], p["style_channels"], p["guide_influence"]
        ),
        "occurrence_weight": occurrence_weight_of(
            p["uniformity"], p["patch_width"], p["source_pixels"], p["target_patches"]
        ),
    }


def stage_random_nnf(p, a):
    """Stage of section 5."""
    shape = source_shape_of(p)
    return {"nnf": random_nnf(a["nnf"], shape, radius_of(p), int(p["seed"]), p["level"])}


def stage_downsample(p, a):
    """Stage of section 6."""
    return {"image": downsample(a["image"])}


def stage_upsample_nnf(p, a):
    """Stage of section 6."""
    return {"nnf": upsample_nnf(a["coarse_nnf"], a["nnf"], source_shape_of(p), radius_of(p))}


def stage_occurrence(p, a):
    """Stage of section 1."""
    omega, omega_sums = occurrence(a["nnf"], source_shape_of(p), radius_of(p))
    return {"omega": omega, "omega_sums": omega_sums}


def stage_delta(p, a):
    """Stage of section 3."""
    n_g = p["guide_channels"]
    guides, style = (
        delta(
            a["source"][..., part], a["target"][..., part], a["weights"][part], a["nnf"],
            radius_of(p),
        )
        for part in (slice(None, n_g), slice(n_g, None))
    )  # fmt: skip
    return {"delta_guides": guides, "delta_style": style}


def stage_phi(p, a):
    """Stage of section 3."""
    return {"phi": phi(a["delta"], a["omega_sums"], p["occurrence_weight"], a["nnf"])}


def stage_guide_map(p, a):
    """Stage of section 12."""
    n_g = p["guide_channels"]
    source_sums, target_sums, variances, white = guide_map(
        a["source"][..., :n_g], a["target"][..., :n_g], a["weights"][:n_g], radius_of(p),
        p["epsilon"],
    )  # fmt: skip
    return {
        "source_sums": source_sums,
        "target_sums": target_sums,
        "variances": variances,
        "white": white,
    }


def stage_white_delta(p, a):
    """Stage of section 12."""
    n_g, radius = p["guide_channels"], radius_of(p)
    source_sums = source_patch_sums(a["source"][..., :n_g], radius)
    target_sums = target_patch_sums(a["target"][..., :n_g], radius)
    values = white_delta(
        a["source"], a["target"], a["weights"], a["nnf"], radius, source_sums, target_sums,
        a["white"],
    )  # fmt: skip
    return {"delta": values}


def pass_arguments(p, a):
    """List what propagation, random search and an iteration have in common."""

    def measure(centres):
        return delta(a["source"], a["target"], a["weights"], centres, radius_of(p))

    weight = p["occurrence_weight"]
    return a["nnf"], a["delta"], a["omega_sums"], weight, radius_of(p), measure


def case_stream(purpose, p):
    """Give the stream that the parameters name."""
    return make_stream(purpose, int(p["seed"]), p["level"], p["vote"], p["iteration"])


def stage_propagation(p, a):
    """Stage of section 7."""
    proposed_nnf, proposed_delta = propagation(*pass_arguments(p, a), p["distance"])
    return {"proposed_nnf": proposed_nnf, "proposed_delta": proposed_delta}


def stage_random_search(p, a):
    """Stage of section 8."""
    stream = case_stream(RANDOM_SEARCH, p)
    proposed_nnf, proposed_delta = random_search(*pass_arguments(p, a), stream)
    return {"proposed_nnf": proposed_nnf, "proposed_delta": proposed_delta}


def stage_commit_order(p, a):
    """Stage of section 9."""
    return {"order": commit_order(case_stream(COMMIT_ORDER, p))}


def stage_commit(p, a):
    """Stage of section 9."""
    nnf, delta_values, omega_sums, moves = commit(
        a["nnf"], a["delta"], a["proposed_nnf"], a["proposed_delta"], a["omega_sums"],
        p["occurrence_weight"], radius_of(p), commit_order(case_stream(COMMIT_ORDER, p)),
    )  # fmt: skip
    return {"nnf": nnf, "delta": delta_values, "omega_sums": omega_sums, "moves": moves}


def stage_iteration(p, a):
    """Stage of section 10."""
    nnf, delta_values, omega_sums = patchmatch_iteration(
        *pass_arguments(p, a), int(p["seed"]), p["level"], p["vote"], p["iteration"]
    )
    return {"nnf": nnf, "delta": delta_values, "omega_sums": omega_sums}


def stage_vote(p, a):
    """Stage of section 11."""
    return {"style": vote(a["style"], a["nnf"], radius_of(p), p["outliers"])}


def stage_level(p, a):
    """Stage of section 13."""
    style, nnf, omega = run_level(
        a["source"], a["target_guides"], a["weights"], a["nnf"], radius_of(p),
        p["occurrence_weight"], p["votes"], p["iterations"], int(p["seed"]), p["level"],
    )  # fmt: skip
    return {"style": style, "nnf": nnf, "omega": omega}


def stage_run(p, a, stylit=None):
    """Stage of section 13."""
    unmasked = np.zeros(a["target_guides"].shape[:2], bool)
    mask = a["mask"] if p["masked"] else unmasked
    image, nnf, omega = run(a["style"], a["source_guides"], a["target_guides"], mask, p, stylit)
    return {"image": image, "nnf": nnf, "omega": omega}


def stage_budget(p, a):
    """Stage of section 14."""
    return {"count": budget(a["errors"], p["share"])}


def stage_knee(p, a):
    """Stage of section 14."""
    return {"x": knee(a["a"], a["b"])}


def stage_lower_bound(p, a):
    """Stage of section 16."""
    bound = lower_bound(
        a["source"], a["target"], a["weights"], a["nnf"], radius_of(p), p["guide_channels"]
    )
    return {"bound": bound}


def stage_invert_nnf(p, a):
    """Stage of section 15."""
    claims, errors = invert_nnf(a["nnf"], a["delta"], a["claims"], a["errors"], radius_of(p))
    return {"claims": claims, "errors": errors}


def stage_settle(p, a):
    """Stage of section 15."""
    nnf, delta_values, claimed = settle(
        a["claims"], a["errors"], a["fixed"], a["limits"], a["nnf"], a["delta"], radius_of(p),
        p["last_error"], p["last_claims"],
    )  # fmt: skip
    return {"nnf": nnf, "delta": delta_values, "claimed": claimed}


def stylit_of(p):
    """List the parameters of StyLit's search."""
    return p["budget"], p["fixed_share"], p["error_limit"]


def stage_stylit_search(p, a):
    """Stage of section 15."""
    nnf, delta_values, counts = stylit_search(
        a["source"], a["target"], a["weights"], a["nnf"], a["delta"], radius_of(p),
        p["iterations"], stylit_of(p), int(p["seed"]), p["level"], p["vote"],
    )  # fmt: skip
    return {"nnf": nnf, "delta": delta_values, "fixed_counts": counts}


def stage_stylit_run(p, a):
    """Stage of section 15."""
    return stage_run({**p, "uniformity": 0, "method": "ref"}, a, stylit_of(p))


STAGES = {
    "philox": stage_philox,
    "weights": stage_weights,
    "random_nnf": stage_random_nnf,
    "downsample": stage_downsample,
    "upsample_nnf": stage_upsample_nnf,
    "occurrence": stage_occurrence,
    "delta": stage_delta,
    "phi": stage_phi,
    "guide_map": stage_guide_map,
    "white_delta": stage_white_delta,
    "propagation": stage_propagation,
    "random_search": stage_random_search,
    "commit_order": stage_commit_order,
    "commit": stage_commit,
    "iteration": stage_iteration,
    "vote": stage_vote,
    "level": stage_level,
    "run": stage_run,
    "budget": stage_budget,
    "knee": stage_knee,
    "lower_bound": stage_lower_bound,
    "invert_nnf": stage_invert_nnf,
    "settle": stage_settle,
    "stylit_search": stage_stylit_search,
    "stylit_run": stage_stylit_run,
}

OUTPUT_TYPES = {
    "words": np.uint32,
    "weights": np.int64,
    "occurrence_weight": np.int64,
    "nnf": np.int32,
    "proposed_nnf": np.int32,
    "omega": np.int32,
    "omega_sums": np.int32,
    "order": np.int32,
    "image": np.uint8,
    "style": np.uint8,
    "delta": np.int64,
    "delta_guides": np.int64,
    "delta_style": np.int64,
    "proposed_delta": np.int64,
    "phi": np.int64,
    "source_sums": np.uint32,
    "target_sums": np.uint32,
    "variances": np.int64,
    "white": np.bool_,
    "moves": np.int64,
    "count": np.int64,
    "x": np.float64,
    "bound": np.int64,
    "claims": np.int32,
    "errors": np.int64,
    "claimed": np.bool_,
    "fixed_counts": np.int64,
}


def widen(array):
    """Give integers 64 bits; leave booleans and doubles as they are."""
    array = np.asarray(array)
    return array.astype(np.int64) if array.dtype.kind in "iu" else array


def run_case(stage, parameters, arrays):
    """Compute one stage: a dictionary of the output arrays."""
    outputs = STAGES[stage](parameters, {name: widen(array) for name, array in arrays.items()})
    return {name: np.asarray(value, OUTPUT_TYPES[name]) for name, value in outputs.items()}


def main(arguments):
    """Read a case from one folder and write its outputs into another."""
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    source, destination = Path(arguments[0]), Path(arguments[1])
    case = json.loads((source / "case.json").read_text(encoding="utf-8"))
    arrays = {path.stem: np.load(path, allow_pickle=False) for path in source.glob("*.npy")}
    outputs = run_case(case["stage"], case.get("parameters", {}), arrays)
    destination.mkdir(parents=True, exist_ok=True)
    for name, array in outputs.items():
        np.save(destination / f"{name}.npy", array, allow_pickle=False)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
