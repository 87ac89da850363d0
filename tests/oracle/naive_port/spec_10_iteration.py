"""10. One PatchMatch iteration."""

from .spec_04_random_numbers import COMMIT_ORDER, RANDOM_SEARCH, make_stream
from .spec_07_propagation import pass_arguments, propagation
from .spec_08_random_search import random_search
from .spec_09_commit import commit, commit_order


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


def stage_iteration(p, a):
    """Do stage iteration."""
    nnf, delta_values, omega_sums = patchmatch_iteration(
        *pass_arguments(p, a), int(p["seed"]), p["level"], p["vote"], p["iteration"]
    )
    return {"nnf": nnf, "delta": delta_values, "omega_sums": omega_sums}


STAGES = {"iteration": stage_iteration}
