"""Seam costs against section 4, in exact fractions."""

from fractions import Fraction

import numpy as np
import pytest
from numba import njit

from stylit_ref.texture.formulae.seam_cost import LARGEST_COST, ONE, edge_cost, seam_cost


@njit
def cost(here, after_here, there, before_there, eta, exponent):
    return seam_cost(here, after_here, there, before_there, eta, exponent)


@njit
def cost_between(colours, here, there, step, eta, exponent):
    return edge_cost(colours, here, there, step, eta, exponent)


def packed(colour):
    red, green, blue = (int(channel) for channel in colour)
    return np.int32(red | green << 8 | blue << 16)


def by_the_text(here, after_here, there, before_there, eta, exponent):
    def squared(a, b):
        return sum((int(p) - int(q)) ** 2 for p, q in zip(a, b, strict=True))

    quotient = Fraction(
        squared(here, before_there) + squared(there, after_here),
        eta + squared(here, after_here) + squared(there, before_there),
    )
    return quotient**exponent * ONE


@pytest.mark.parametrize("exponent", [1, 2, 3])
@pytest.mark.parametrize("eta", [1, 1000, 10_000_000])
def test_a_seam_costs_what_the_text_says(exponent, eta):
    rng = np.random.default_rng(exponent)
    for _ in range(200):
        colours = rng.integers(0, 256, (4, 3))
        expected = min(by_the_text(*colours, eta, exponent), LARGEST_COST)
        found = cost(*map(packed, colours), eta, exponent)
        # Three roundings to 24 bits, then down to an integer.
        assert expected * (1 - Fraction(4, 1 << 24)) - 1 <= found
        assert found <= expected * (1 + Fraction(4, 1 << 24))


def test_a_seam_costs_the_same_from_both_sides():
    rng = np.random.default_rng(2)
    for _ in range(50):
        a, after_a, b, before_b = map(packed, rng.integers(0, 256, (4, 3)))
        assert cost(a, after_a, b, before_b, 1000, 2) == cost(b, before_b, a, after_a, 1000, 2)


def test_a_continued_piece_costs_nothing():
    colours = np.random.default_rng(3).integers(0, 1 << 24, 50).astype(np.int32)
    assert cost_between(colours, 10, 11, 1, 1, 2) == 0
    assert cost_between(colours, 10, 17, 7, 1, 2) == 0


def test_equal_colours_from_elsewhere_cost_nothing():
    colours = np.tile(np.arange(7, dtype=np.int32) * 1000, 6)
    assert cost_between(colours, 10, 18, 1, 1000, 2) == 0  # 7 further than 11


def test_the_literal_first_term_would_vanish():
    """M^S of the text passes S[t] as t_e and as S[t_s - δ]: what S shows there is its own."""
    rng = np.random.default_rng(4)
    here, after_here, there, before_there = rng.integers(0, 256, (4, 3))
    literal_first = ((here - here) ** 2).sum()
    assert literal_first == 0
    assert by_the_text(here, after_here, there, before_there, 1000, 2) > 0
