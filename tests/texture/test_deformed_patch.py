"""A deformed patch is given up early only where the plain one is no dearer."""

import numpy as np
import pytest

from stylit_ref.texture.formulae.deformation import power_table
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.passes.acceptance import cost_change, costs_of_change
from stylit_ref.texture.passes.context import Context, read_context
from stylit_ref.texture.passes.deformation import rasterize
from stylit_ref.texture.passes.deformed_patch import TOO_DEAR, deformed_change
from stylit_ref.texture.passes.layout import make_workspace
from stylit_ref.texture.session import TextureSession


@pytest.mark.slow
@pytest.mark.parametrize("largest_shift", [0, 1, 6])
@pytest.mark.parametrize("contrast", [1, 256])
def test_row_by_row_the_cheaper_patch_is_that_of_two_whole_ones(largest_shift, contrast):
    """No shift at all costs what the plain patch does: it is not cheaper."""
    rng = np.random.default_rng(contrast)
    exemplar = rng.integers(0, contrast, (40, 41, 3), dtype=np.uint16).astype(np.uint8)
    params = TextureParams.preset("paper", radius=8, max_deformation=6)
    session = TextureSession([exemplar], (30, 31), params, seed=3)
    polar, sources, settings = session.fitted(8)
    powers, work = power_table(1.0), make_workspace(polar, 4, 6, 1)
    context = Context(*work.context[0], work.locked[0])
    plain, deformed, other = (np.empty(polar.radius_at.size, np.int32) for _ in range(3))
    rows, columns = polar.inside.shape
    texture, half_width = session.texture, polar.half_width
    given_up = 0
    for source in rng.choice(sources.centres, 40):
        y, x = (int(at) for at in rng.integers(0, session.size))
        read_context(texture, sources.colours, settings.stride, y, x, half_width, -1, context)
        path = rng.integers(columns // 2, columns, rows).astype(np.int32)
        shifts = rng.integers(-largest_shift, largest_shift + 1, rows).astype(np.int32)
        cut = int(source), settings, polar, path, shifts, powers
        whole = rasterize(*cut, False, sources.clearance, context, plain)
        before, after = costs_of_change(texture, sources, settings, y, x, half_width, plain)
        rasterize(*cut, True, sources.clearance, context, deformed)
        expected = cost_change(texture, sources, settings, y, x, half_width, deformed)
        found = deformed_change(
            texture, sources, settings, polar, y, x, int(source), path, shifts, powers, context,
            after if whole else TOO_DEAR, other,
        )  # fmt: skip
        if found == TOO_DEAR:
            given_up += 1
            assert expected >= after - before
        else:
            assert found == expected
            np.testing.assert_array_equal(other, deformed)
    assert given_up > 0
