"""The cut of section 4 against brute force."""

import numpy as np
import pytest

from stylit_ref.texture.formulae.polar import BLOCKED, WEIGHT_BITS, cost_limits, make_polar
from stylit_ref.texture.passes.cut import accumulate, closed_path


def random_tables(rows, columns, max_jump, seed, largest=5000):
    rng = np.random.default_rng(seed)
    crossing = np.full((rows, columns + 2 * max_jump), BLOCKED, np.int32)
    inner = slice(max_jump, max_jump + columns)
    crossing[:, inner] = rng.integers(-largest, largest, (rows, columns))
    steps = np.zeros_like(crossing)
    steps[:, inner] = rng.integers(0, largest // 8, (rows, columns)).cumsum(axis=1)
    steps[:, max_jump + columns :] = steps[:, [max_jump + columns - 1]]
    return crossing, steps


def cut(crossing, steps, max_jump, arrivals=None):
    rows, padded = crossing.shape
    totals = np.empty((rows + 1, padded), np.int32)
    room = np.empty((2, padded), np.int32)
    arrivals = np.zeros(padded, np.int32) if arrivals is None else arrivals
    accumulate(crossing, steps, max_jump, arrivals, totals, *room)
    path, ends = np.empty(rows, np.int32), np.empty((2, padded + 1), np.int32)
    cost = closed_path(totals, steps, max_jump, arrivals, path, *ends)
    return totals, path, cost


def second_cut(crossing, steps, max_jump):
    """The cut that begins with what the first pass paid to arrive."""
    ends = cut(crossing, steps, max_jump)[0][-1]
    return cut(crossing, steps, max_jump, np.minimum(ends - ends.min(), BLOCKED))


def cost_of(path, crossing, steps, max_jump):
    """What a closed path costs: Eq. of section 4, "Patch cost"."""
    rows = len(path)
    columns = path.astype(int) + max_jump
    total = 0
    for y in range(rows):
        after = columns[(y + 1) % rows]
        assert abs(after - columns[y]) <= max_jump
        step = abs(int(steps[y, after]) - int(steps[y, columns[y]]))
        total += int(crossing[y, columns[y]]) + step
    return total


def cheapest_closed(crossing, steps, max_jump):
    """The least cost of all closed paths: one dynamic programming for every start."""
    rows, padded = crossing.shape
    columns = padded - 2 * max_jump
    best = []
    for start in range(columns):
        totals = np.full(columns, 1 << 40)
        totals[start] = crossing[0, max_jump + start]
        for y in range(1, rows + 1):
            new = np.full(columns, 1 << 40)
            for i in range(columns):
                for j in range(max(0, i - max_jump), min(columns, i + max_jump + 1)):
                    step = abs(int(steps[y - 1, i + max_jump]) - int(steps[y - 1, j + max_jump]))
                    new[i] = min(new[i], totals[j] + step)
                if y < rows:
                    new[i] += int(crossing[y, i + max_jump])
            totals = new
        best.append(totals[start])
    return best


@pytest.mark.parametrize("max_jump", [1, 2, 4, 5, 8])
@pytest.mark.parametrize("arrived", [0, 3000])
def test_every_state_is_the_minimum_over_its_jumps(max_jump, arrived):
    crossing, steps = random_tables(17, 24, max_jump, max_jump)
    rows, padded = crossing.shape
    arrivals = np.random.default_rng(0).integers(0, arrived + 1, padded, np.int32)
    totals, _, _ = cut(crossing, steps, max_jump, arrivals)
    expected = np.full((rows + 1, padded), BLOCKED, np.int64)
    expected[0] = np.minimum(crossing[0].astype(np.int64) + arrivals, BLOCKED)
    for y in range(1, rows + 1):
        for x in range(max_jump, padded - max_jump):
            reached = min(
                expected[y - 1, j] + abs(int(steps[y - 1, x]) - int(steps[y - 1, j]))
                for j in range(x - max_jump, x + max_jump + 1)
            )
            if y < rows:
                reached = min(reached + int(crossing[y, x]), BLOCKED)
            expected[y, x] = reached
    np.testing.assert_array_equal(totals, expected)


@pytest.mark.parametrize("seed", range(30))
def test_the_cut_closes_and_costs_what_it_says(seed):
    max_jump = 1 + seed % 4
    crossing, steps = random_tables(19, 23, max_jump, seed)
    _, path, cost = cut(crossing, steps, max_jump)
    assert cost == cost_of(path, crossing, steps, max_jump)


@pytest.mark.parametrize("seed", range(30))
def test_the_second_cut_closes_and_costs_what_it_says(seed):
    max_jump = 1 + seed % 4
    crossing, steps = random_tables(19, 23, max_jump, seed)
    _, path, cost = second_cut(crossing, steps, max_jump)
    assert cost == cost_of(path, crossing, steps, max_jump)


def test_a_second_pass_nearly_always_finds_the_optimum():
    found = np.zeros(2)
    for seed in range(100):
        crossing, steps = random_tables(19, 15, 2, seed)
        optimum = min(cheapest_closed(crossing, steps, 2))
        costs = [way(crossing, steps, 2)[2] for way in (cut, second_cut)]
        assert min(costs) >= optimum
        found += np.array(costs) == optimum
    assert found[1] >= 95 > found[0]


@pytest.mark.parametrize("seed", range(30))
def test_in_a_single_column_only_it_can_begin_and_end(seed):
    """So the least of all columns is the optimum."""
    crossing, steps = random_tables(11, 9, 2, seed)
    for start, cheapest in enumerate(cheapest_closed(crossing, steps, 2)):
        arrivals = np.full(13, BLOCKED, np.int32)
        arrivals[2 + start] = 0
        _, path, cost = cut(crossing, steps, 2, arrivals)
        assert cost == cheapest == cost_of(path, crossing, steps, 2)
        assert path[0] == start


def test_ties_go_to_the_left():
    crossing, steps = random_tables(12, 20, 3, 0)
    crossing[:, 3:23], steps[:] = 7, 0
    _, path, cost = cut(crossing, steps, 3)
    assert cost == 7 * 12
    assert (path == 0).all()


def test_blocked_cuts_are_told_by_their_cost():
    crossing, steps = random_tables(12, 20, 2, 0)
    crossing[5] = BLOCKED
    _, _, cost = cut(crossing, steps, 2)
    assert cost >= BLOCKED // 2


@pytest.mark.parametrize("max_jump", [1, 4, 8, 11])
@pytest.mark.parametrize("weighting", ["arc_length", "printed"])
def test_at_the_limit_the_table_holds_what_python_computes(max_jump, weighting):
    """All edges at the limit, as much hidden as can be, and blocked states: from noise."""
    polar = make_polar(24, 2.0, 1.5, weighting)
    limits = cost_limits(polar)
    rows, columns = polar.inside.shape
    rng = np.random.default_rng(max_jump)
    edge = limits.new * 3 // 2
    paid = edge * polar.cut_weight.astype(np.int64) >> WEIGHT_BITS
    hidden = (limits.hidden // rows // columns * np.arange(1, columns + 1)).astype(np.int64)
    crossing = np.full((rows, columns + 2 * max_jump), BLOCKED, np.int32)
    inner = slice(max_jump, max_jump + columns)
    crossing[:, inner] = np.where(rng.random((rows, columns)) < 0.5, paid, paid // 99 - hidden)
    crossing[rng.random(crossing.shape) < 0.02] = BLOCKED
    steps = np.zeros_like(crossing)
    steps[:, inner] = (edge * polar.step_weight.astype(np.int64) >> WEIGHT_BITS).cumsum()
    steps[:, max_jump + columns :] = steps[:, [max_jump + columns - 1]]
    totals, path, cost = cut(crossing, steps, max_jump)
    exact = crossing[0].astype(np.int64)
    for y in range(1, rows + 1):
        reached = np.full(columns, 1 << 60)
        for jump in range(-max_jump, max_jump + 1):
            there = slice(max_jump + jump, max_jump + jump + columns)
            step = abs(steps[y - 1, inner].astype(np.int64) - steps[y - 1, there])
            reached = np.minimum(reached, exact[there] + step)
        exact = np.full(columns + 2 * max_jump, BLOCKED, np.int64)
        if y < rows:
            reached = np.minimum(reached + crossing[y, inner], BLOCKED)
        exact[inner] = reached
        np.testing.assert_array_equal(totals[y], exact)
    assert cost == cost_of(path, crossing, steps, max_jump)
