import numpy as np
import pytest

from stylit_ref.stylization.mask import (
    active_patches,
    downsample_mask,
    fill_masked,
    filled_channels,
    wholly_assigned,
)


def test_mask_keeps_every_pixel_that_has_a_descendant():
    synthesized = np.zeros((7, 6), bool)
    synthesized[6, 0] = synthesized[1, 4] = True
    expected = np.zeros((3, 3), bool)
    expected[2, 0] = expected[0, 2] = True
    np.testing.assert_array_equal(downsample_mask(synthesized), expected)


@pytest.mark.parametrize("patch_width", [1, 3, 5])
def test_wholly_assigned_pixels_are_those_whose_patches_all_take_part(patch_width):
    assigned = np.random.default_rng(0).random((12, 9)) < 0.93
    radius = patch_width // 2
    expected = np.array(
        [
            [
                assigned[
                    max(y - radius, 0) : y + radius + 1, max(x - radius, 0) : x + radius + 1
                ].all()
                for x in range(9)
            ]
            for y in range(12)
        ]
    )
    assert 0 < expected.mean() < 1
    np.testing.assert_array_equal(wholly_assigned(assigned, patch_width), expected)


def test_unmasked_pixels_are_wholly_assigned():
    mask = np.random.default_rng(0).random((30, 31)) < 0.97
    mask[5:17, 4:19] = True
    shown = wholly_assigned(active_patches(mask, 5), 5)
    assert not (~mask & ~shown).any()
    assert not shown.all()


MASK = np.eye(3, dtype=bool)
GREY, COLOUR = (np.full((3, 3, channels), 9, np.uint8) for channels in (1, 3))
CLEAR = np.dstack([COLOUR, np.full((3, 3), 50, np.uint8)])


@pytest.mark.parametrize(
    ("image", "fill", "shown", "filled"),
    [
        (GREY, 2 * GREY, [9], [18]),
        (GREY, None, [9, 255], [0, 0]),
        (GREY, (2 * GREY)[:, :, 0], [9], [18]),
        (GREY, 2 * COLOUR, [9, 9, 9], [18, 18, 18]),
        (COLOUR, 2 * GREY, [9, 9, 9], [18, 18, 18]),
        (COLOUR, None, [9, 9, 9, 255], [0, 0, 0, 0]),
        (COLOUR, CLEAR, [9, 9, 9, 255], [9, 9, 9, 50]),
        (CLEAR, None, [9, 9, 9, 50], [0, 0, 0, 0]),
        (CLEAR, 2 * GREY, [9, 9, 9, 50], [18, 18, 18, 255]),
    ],
)
def test_an_image_and_its_fill_share_colours_and_alpha(image, fill, shown, filled):
    before = image.copy()
    result = fill_masked(image, MASK, fill)
    channels = None if fill is None else np.atleast_3d(fill).shape[2]
    assert result.shape == (3, 3, filled_channels(image.shape[2], channels))
    assert (result[~MASK] == shown).all()
    assert (result[MASK] == filled).all()
    np.testing.assert_array_equal(image, before)


@pytest.mark.parametrize(("dtype", "opaque"), [(np.uint16, 65535), (np.float32, 1)])
def test_opaque_is_the_largest_value_of_the_depth(dtype, opaque):
    assert (fill_masked(GREY.astype(dtype), MASK, None)[~MASK] == [9, opaque]).all()
