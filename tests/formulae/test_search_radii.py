import pytest

from stylit_ref.formulae.search_radii import (
    number_of_radii,
    search_draw,
    search_radius,
    search_words,
)


@pytest.mark.parametrize(
    ("side", "radii"),
    [
        (1, []),
        (2, [1]),
        (3, [1]),
        (4, [1, 2]),
        (7, [1, 2]),
        (8, [1, 2, 4]),
        (1200, [2**k for k in range(10)]),
    ],
)
def test_radii_double_up_to_half_the_side(side, radii):
    assert [search_radius(k) for k in range(number_of_radii(side))] == radii


def test_no_two_candidates_share_a_word():
    """Two words each, four a draw, the first draw being number 0."""
    found = [(search_draw(k), word) for k in range(7) for word in search_words((0, 1, 2, 3), k)]
    assert found == [(n // 4, n % 4) for n in range(14)]
