"""The tables of the polar map against the plane."""

import numpy as np
import pytest

from stylit_ref.texture.formulae.polar import (
    BLOCKED,
    MARGIN,
    WEIGHT_BITS,
    WEIGHTINGS,
    cost_limits,
    halvings,
    make_polar,
    polar_size,
)

ONE = 1 << WEIGHT_BITS


def test_the_table_has_the_size_of_section_4():
    assert polar_size(64, 2.0, 1.5) == (603, 128)
    assert polar_size(128, 2.0, 1.5) == (1206, 256)


@pytest.mark.parametrize("weighting", WEIGHTINGS)
@pytest.mark.parametrize("radius", [16, 64])
def test_appendix_a_existing_seams_weigh_in_the_table_what_they_cost_in_the_disc(weighting, radius):
    polar = make_polar(radius, 2.0, 1.5, weighting)
    side = 2 * (radius + MARGIN) + 1
    seams = np.random.default_rng(radius).integers(0, 1000, side * side)
    in_table = (seams[polar.inside] * polar.area / ONE).sum()
    in_disc = seams[polar.radius_at < radius * 256].sum()
    assert in_table == pytest.approx(in_disc, rel=0.02)


@pytest.mark.parametrize(("weighting", "times"), [("arc_length", 1), ("printed", 2)])
@pytest.mark.parametrize("radius", [10, 32])
def test_a_round_cut_costs_its_length_and_as_printed_n_rho_times_that(weighting, times, radius):
    """A circle of edges that cost 1 crosses 8 r of them."""
    polar = make_polar(32, 2.0, 1.5, weighting)
    along = polar.cut_weight[2 * radius - 1] / ONE
    cost = (along * (polar.cut_cosine + polar.cut_sine) / ONE).sum()
    assert cost == pytest.approx(times * 8 * radius, rel=0.01)


def test_a_step_along_a_row_costs_the_edges_it_crosses():
    """From the centre to (32 cos θ, 32 sin θ): so many edges x and y."""
    polar = make_polar(32, 2.0, 1.5, "arc_length")
    rows = polar.inside.shape[0]
    angles = (np.arange(rows) + 0.5) * 2 * np.pi / rows
    costs = polar.step_weight.sum() / ONE * (polar.step_cosine + polar.step_sine) / ONE
    expected = 32 * (abs(np.cos(angles)) + abs(np.sin(angles)))
    np.testing.assert_allclose(costs, expected, rtol=1e-3)


def test_edges_lie_where_the_cut_crosses_them():
    radius = 8
    polar = make_polar(radius, 2.0, 1.5, "arc_length")
    side, centre = 2 * (radius + MARGIN) + 1, radius + MARGIN
    # In row 0, to the right: the cut of radius 4 lies between the pixels 3 and 4, or 4 and 5.
    assert polar.cut_x[0, 7] == centre * side + centre + 4
    assert polar.inside[0, 7] == centre * side + centre + 4


@pytest.mark.slow
@pytest.mark.parametrize("radius", [1, 2, 16, 64, 128, 512])
@pytest.mark.parametrize("radial_samples", [0.25, 2.0, 8.0])
@pytest.mark.parametrize("weighting", WEIGHTINGS)
def test_no_table_can_overflow(radius, radial_samples, weighting):
    """With all costs at their limits, in Python's integers."""
    polar = make_polar(radius, radial_samples, 1.5, weighting)
    limits = cost_limits(polar)
    rows, columns = polar.inside.shape
    half, largest = 1 << (WEIGHT_BITS - 1), (1 << 31) - 1

    def weighted(value, weight):
        product = int(value) * int(weight) + half
        assert product <= largest
        return product >> WEIGHT_BITS

    direction = int(max((polar.cut_cosine + polar.cut_sine).max(), ONE))
    edge = weighted(limits.new, direction)
    cut = max(weighted(edge, weight) for weight in polar.cut_weight)
    across = sum(weighted(edge, weight) for weight in polar.step_weight)
    assert across <= 1 << 28
    assert BLOCKED + across + cut <= largest
    assert max(weighted(limits.existing, weight) for weight in polar.area) <= largest

    # All that is hidden sits on the pixel that most samples fall on.
    areas = np.broadcast_to(polar.area, polar.inside.shape)
    share = np.bincount(polar.inside.ravel(), areas.ravel()).max() / ONE
    assert limits.hidden * share + rows * columns / 2 < BLOCKED // 2
    assert -(BLOCKED // 2) - BLOCKED - across >= -largest - 1


@pytest.mark.parametrize(("total", "most", "count"), [(0, 5, 0), (5, 5, 0), (6, 5, 1), (24, 5, 3)])
def test_a_total_is_halved_until_it_fits(total, most, count):
    def plain(value):
        return halvings.py_func(value, most)

    assert plain(total) == count
    assert total >> count <= most
