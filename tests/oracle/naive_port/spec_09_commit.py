"""9. Commit."""

from .spec_01_names import assigned_pixels, box_sum, patch_counts, radius_of, target_grid
from .spec_03_metric import phi
from .spec_04_random_numbers import COMMIT_ORDER, below, case_stream, draw_words


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


def stage_commit_order(p, a):
    """Do stage commit_order."""
    return {"order": commit_order(case_stream(COMMIT_ORDER, p))}


def stage_commit(p, a):
    """Do stage commit."""
    nnf, delta_values, omega_sums, moves = commit(
        a["nnf"], a["delta"], a["proposed_nnf"], a["proposed_delta"], a["omega_sums"],
        p["occurrence_weight"], radius_of(p), commit_order(case_stream(COMMIT_ORDER, p)),
    )  # fmt: skip
    return {"nnf": nnf, "delta": delta_values, "omega_sums": omega_sums, "moves": moves}


STAGES = {"commit_order": stage_commit_order, "commit": stage_commit}
