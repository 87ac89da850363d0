"""One patch, pass by pass."""

import numpy as np
import pytest
from small_textures import spots

from eval.documents.lasram.one_patch import OnePatch
from eval.documents.lasram.patch_costs import SHARED, stage_shares
from stylit_ref import TextureParams, TextureSession

PARAMS = TextureParams.preset("paper", radius=12, max_deformation=6)


@pytest.fixture
def session():
    session = TextureSession([spots(1, 64)], (64, 64), PARAMS)
    session.step()
    return session


@pytest.fixture
def patch(session):
    patch = OnePatch(session, (30, 34), int(session.exemplars.centres(24)[40]))
    for stage in (patch.read, patch.begin_cut, patch.cut, patch.begin_alignment, patch.align):
        stage()
    return patch


@pytest.mark.slow
def test_the_texture_stays_as_it_is(session):
    before = session.addresses.copy(), session.recount()
    patch = OnePatch(session, (3, 60), int(session.exemplars.centres(24)[0]))
    for stage in (patch.read, patch.begin_cut, patch.cut, patch.begin_alignment, patch.align):
        stage()
    patch.write()
    np.testing.assert_array_equal(session.addresses, before[0])
    assert session.recount() == before[1]


def test_the_cut_is_closed_and_jumps_no_farther_than_it_may(patch):
    jumps = np.diff(np.append(patch.path, patch.path[0]))
    assert np.abs(jumps).max() <= PARAMS.max_jump
    assert 0 <= patch.path.min() <= patch.path.max() < patch.polar.inside.shape[1]


def test_most_fixed_first_shifts_align_worse_than_ours(patch):
    ours = patch.aligned
    fixed = []
    for start in range(2 * patch.settings.max_shift + 1):
        patch.align(start)
        assert patch.shifts[0] == start - patch.settings.max_shift
        fixed.append(patch.aligned)
    assert ours < np.median(fixed)


def test_a_patch_without_deformation_shows_the_exemplar_as_it_is(patch):
    patch.write()
    side = patch.polar.half_width.size
    offsets = np.arange(side) - side // 2
    whole = (patch.source + offsets[:, None] * patch.settings.stride + offsets).ravel()
    written = patch.patch >= 0
    assert written.any()
    np.testing.assert_array_equal(patch.patch[written], whole[written])
    np.testing.assert_array_equal(patch.deformed >= 0, written)
    assert (patch.deformed != patch.patch).any()


def test_shares_of_the_four_stages_are_shares(session):
    shares = stage_shares(session)
    assert tuple(shares) == SHARED
    assert all(share > 0 for share in shares.values())
    assert sum(shares.values()) < 1
