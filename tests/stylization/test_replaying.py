"""Masks, fills, and what a field knows of its run."""

import logging

import numpy as np
import pytest
from small_scene import small_scene

from stylit_ref import Field, InputError, Params, replay, stylize

QUICK = Params(levels=3, votes=2, patchmatch_iterations=2)
STYLE, *GUIDES = small_scene()
SIZE = STYLE.shape[:2]
MASK = np.zeros((38, 44), bool)
MASK[10:30, 8:36] = True
HOLES = MASK.copy()
HOLES[15:17, 12:20] = False
HOLES[3, 40] = True
"""A mask that cannot be told from the patches that take part."""
FILL = np.random.default_rng(1).integers(0, 256, (38, 44, 3), dtype=np.uint8)
FILLS = {
    "none": None,
    "colour": FILL,
    "grey": FILL[:, :, 0],
    "transparent": np.dstack([FILL // 2, np.full((38, 44), 130, np.uint8)]),
}


def large(image):
    return image.repeat(2, axis=0).repeat(2, axis=1)


@pytest.fixture(scope="module")
def masked():
    """A masked run, and its field."""
    result = stylize(STYLE, *GUIDES, QUICK, mask=HOLES)
    return result, Field(result.nnf, QUICK.patch_width, 0, SIZE, HOLES)


@pytest.mark.parametrize("fill", FILLS.values(), ids=FILLS)
@pytest.mark.parametrize("mask", [MASK, HOLES, np.zeros_like(MASK)], ids=["open", "holes", "empty"])
def test_a_masked_run_replays_to_its_own_bytes(mask, fill):
    result = stylize(STYLE, *GUIDES, QUICK, mask=mask, fill=fill)
    field = Field(result.nnf, mask=mask)
    np.testing.assert_array_equal(replay(field, STYLE, fill=fill), result.image)
    given = replay(result.nnf, STYLE, mask=mask, fill=fill)
    np.testing.assert_array_equal(given, result.image)


def test_a_grey_style_without_an_axis_of_channels_replays_to_its_own_bytes():
    result = stylize(STYLE[:, :, 0], *GUIDES, QUICK, mask=MASK, fill=FILL[:, :, 0])
    again = replay(result.nnf, STYLE[:, :, 0], mask=MASK, fill=FILL[:, :, 0])
    assert again.shape == (38, 44)
    np.testing.assert_array_equal(again, result.image)


def test_without_a_mask_unassigned_pixels_are_transparent():
    result = stylize(STYLE, *GUIDES, QUICK, mask=MASK)
    np.testing.assert_array_equal(replay(result.nnf, STYLE), result.image)


@pytest.mark.parametrize("dtype", [np.uint16, np.float32])
def test_deep_and_enlarged_replays_of_a_masked_run(masked, dtype):
    result, field = masked
    unit = 257 if dtype == np.uint16 else 1 / 255
    image = replay(field, (large(STYLE).astype(np.float64) * unit).astype(dtype))
    assert image.dtype == dtype
    np.testing.assert_allclose(image / unit, large(result.image), atol=0.51)
    np.testing.assert_array_equal(image[:, :, 3] == 0, large(HOLES))


def test_masks_and_fills_may_be_enlarged_too(masked):
    _, field = masked
    style, deep = large(STYLE).astype(np.uint16) * 257, FILL.astype(np.uint16) * 257
    small = replay(field, style, fill=deep)
    np.testing.assert_array_equal(replay(field, style, mask=large(HOLES), fill=large(deep)), small)
    np.testing.assert_array_equal(small[large(HOLES)], large(deep)[large(HOLES)])


def test_a_larger_mask_is_obeyed(masked):
    result, field = masked
    wider = HOLES.copy()
    wider[:5] = True
    image = replay(field, STYLE, mask=wider)
    np.testing.assert_array_equal(image[:, :, 3] == 0, wider)
    np.testing.assert_array_equal(image[~wider], result.image[~wider])


def test_the_patch_width_and_the_scale_are_known():
    result = stylize(STYLE, *GUIDES, Params("ref", levels=2, votes=1, patch_width=7))
    field = Field(result.nnf, 7, style_size=SIZE)
    np.testing.assert_array_equal(replay(field, STYLE), result.image)
    np.testing.assert_array_equal(replay(field, STYLE, patch_width=7, scale=1), result.image)
    np.testing.assert_array_equal(replay(field, large(STYLE)), large(result.image))


def test_a_forgotten_patch_width_is_noticed(caplog):
    nnf = np.stack(np.mgrid[3:35, 3:35], axis=-1).astype(np.int32)
    replay(nnf, STYLE)
    assert caplog.record_tuples == [
        (
            "stylit_ref",
            logging.WARNING,
            "patch_width is 5 by default, but the NNF stays 3 pixels away from the edges of the "
            "style, as patches of width 7 do; give the patch width of the run",
        )
    ]
    caplog.clear()
    replay(nnf, STYLE, patch_width=7)
    replay(Field(nnf, 5), STYLE)
    replay(nnf - 1, STYLE)
    assert not caplog.records


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"patch_width": 3}, "patch_width is 3, but the field is of a run with patches of width 5"),
        ({"scale": 2}, "style is 46x40, but the style of the run was 46x40; it must be 2 times as"),
        ({"style": STYLE[1:]}, "style is 46x39, but .* was 46x40; it must be that size or a whole"),
        ({"style": STYLE[::2, ::2]}, "style is 23x20, but the style of the run was 46x40"),
        ({"mask": MASK[:, 1:]}, "mask is 43x38 but the target is 44x38"),
        ({"mask": MASK.astype(np.uint8)}, "mask is uint8 of shape"),
        ({"mask": ~MASK}, "mask shows .* pixels that the run left alone; it must cover the mask"),
        ({"mask": np.ones_like(MASK)}, "mask covers the whole target"),
        ({"fill": FILL.astype(np.uint16)}, "fill has dtype uint16; it must be that of the style"),
        ({"fill": FILL[1:]}, "fill is 44x37 but the target is 44x38"),
    ],
    ids=str,
)
def test_arguments_that_contradict_the_run_are_refused(masked, change, message):
    arguments = {"nnf": masked[1], "style": STYLE} | change
    with pytest.raises(InputError, match=message):
        replay(**arguments)


def test_a_fill_without_a_mask_is_refused():
    nnf = np.full((8, 8, 2), 20, np.int32)
    with pytest.raises(InputError, match="fill needs a mask"):
        replay(nnf, STYLE, fill=STYLE[:8, :8])
