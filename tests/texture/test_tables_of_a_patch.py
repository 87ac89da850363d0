"""What a patch is computed from: nothing of the patch before it, nothing beyond its window."""

import numpy as np
import pytest

from stylit_ref.texture.formulae.polar import WEIGHT_BITS, WEIGHTINGS, cost_limits, make_polar
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.passes.context import Context, read_context
from stylit_ref.texture.passes.cut_costs import existing_seams
from stylit_ref.texture.passes.layout import Texture
from stylit_ref.texture.session import TextureSession


@pytest.mark.parametrize("radius", [1, 2, 4, 8, 64])
def test_a_window_holds_both_pixels_of_every_edge_that_is_read(radius):
    """Of the edges y those below a wide row, too; the lock of the patch before was read there."""
    polar = make_polar(radius, 2.0, 1.5, "arc_length")
    side = polar.half_width.size
    rooms = [np.full(side**2, -9, np.int32) for _ in Context._fields[:-1]]
    context = Context(*rooms, np.full(side**2, 9, np.uint8))
    flat = np.ones((3 * side, 3 * side), np.int32)
    texture = Texture(
        10 * flat,
        flat,
        flat,
        np.zeros(flat.shape, np.uint8),
        np.zeros((1, 1), np.uint8),
        np.zeros((1, 1), np.int32),
    )
    read_context(texture, np.arange(30, dtype=np.int32), 5, 0, 0, polar.half_width, -1, context)
    for j in range(1, side - 1):
        reach, middle = polar.half_width[j], j * side + side // 2
        places = np.arange(middle - reach, middle + reach + 1)
        for near in (places, places + 1, places + side):
            assert (context.here[near] == 10).all()
            assert (context.locked[near] == 0).all()


@pytest.mark.parametrize("weighting", WEIGHTINGS)
@pytest.mark.parametrize("samples", [0.25, 0.3, 1.5, 2.0, 8.0])
@pytest.mark.parametrize("radius", [1, 2, 3, 5, 64])
def test_the_last_cut_is_that_of_the_radius(radius, samples, weighting):
    """However few columns there are: beyond it lie places that nobody fills."""
    polar = make_polar(radius, samples, 1.0, weighting)
    assert polar.border[-1] == 256 * radius
    centre = radius + 2
    for places in (polar.cut_x, polar.cut_y, polar.step_x, polar.step_y, polar.inside):
        y, x = np.divmod(places.astype(int), 2 * centre + 1)
        assert (abs(x - centre) <= polar.half_width[y]).all()


@pytest.mark.parametrize("samples", [0.25, 0.3, 0.7])
def test_with_few_columns_the_running_total_equals_the_recount(samples):
    exemplar = np.random.default_rng(1).integers(0, 256, (30, 31, 3), dtype=np.uint8)
    params = TextureParams(radius=3, radial_samples=samples)
    session = TextureSession([exemplar], (24, 25), params, seed=2)
    accepted = sum(session.step().accepted for _ in range(4))
    assert accepted > 0
    assert session.recount() == session.cost >= 0


@pytest.mark.parametrize("sign", [1, -1])
def test_what_a_pixel_hides_is_cut_off_at_both_ends(sign):
    """Beside a locked pixel a patch may pay 2**25 more than it hides; products have 32 bits."""
    polar = make_polar(4, 2.0, 1.5, "arc_length")
    limit = cost_limits(polar).existing
    hidden = np.full(polar.radius_at.size, sign << 25, np.int32)
    saved = np.zeros(polar.inside.shape, np.int32)
    existing_seams(hidden, polar, 0, limit, saved)
    half = 1 << (WEIGHT_BITS - 1)
    expected = np.cumsum((sign * limit * polar.area.astype(np.int64) + half) >> WEIGHT_BITS)
    np.testing.assert_array_equal(saved, np.broadcast_to(expected, saved.shape))
