"""The stage's packing against what Figure 16 keeps, pixel by pixel."""

import numpy as np
import pytest

from stylit_ref.realtime.packing import (
    PrincipalPacking,
    StagePacking,
    UnpackedStage,
    choose_packing,
    pack,
)
from stylit_ref.realtime.packing.stage import (
    BACKGROUND,
    CAST_SHADOW,
    FOREGROUND,
    STAGE_BUFFERS,
)

SIZES = [(1, 1), (1, 9), (7, 1), (13, 22)]


def random_buffers(size, seed=0, grey=()):
    rng = np.random.default_rng(seed)
    return {
        name: rng.integers(0, 256, size if name in grey else (*size, 3), dtype=np.uint8)
        for name in STAGE_BUFFERS
    }


def label_of(buffers, y, x):
    if buffers["IDMASK"][y, x, 0] >= 128:
        return FOREGROUND
    return CAST_SHADOW if buffers["LIGHTMASK"][y, x, 2] >= 128 else BACKGROUND


def packed_pixel(buffers, y, x):
    """Figure 16, one pixel."""
    red, green = (
        {
            name: np.atleast_1d(buffer[y, x])[c % buffer[y, x].size]
            for name, buffer in buffers.items()
        }
        for c in (0, 1)
    )
    highlight, _, shadow = buffers["LIGHTMASK"][y, x] >= 128
    return [
        red["FULL"], green["FULL"], red["LDE"], green["LDE"], red["LDDE"], green["LDDE"],
        red["LSE"],
        {BACKGROUND: 0, CAST_SHADOW: 128, FOREGROUND: 255}[label_of(buffers, y, x)],
        red["FRESNEL"],
        255 if highlight else 0 if shadow else 128,
    ]  # fmt: skip


@pytest.mark.parametrize("grey", [(), ("FRESNEL",), ("FULL", "LDE", "LDDE", "LSE", "FRESNEL")])
@pytest.mark.parametrize("size", SIZES)
def test_packed_pixels_are_those_of_the_figure(size, grey):
    buffers = random_buffers(size, grey=grey)
    features, labels = pack(StagePacking(), buffers)
    for y, x in np.ndindex(size):
        assert features[y, x].tolist() == packed_pixel(buffers, y, x)
        assert labels[y, x] == label_of(buffers, y, x)


@pytest.mark.parametrize("size", SIZES)
def test_unpacked_pixels_are_the_buffers(size):
    buffers = random_buffers(size, grey=("FRESNEL",))
    features, labels = pack(UnpackedStage(), buffers)
    assert features.shape == (*size, 21)
    assert UnpackedStage.channels[12:15] == ("IDMASK",) * 3
    for y, x in np.ndindex(size):
        label = label_of(buffers, y, x)
        expected = [
            value
            for name in STAGE_BUFFERS
            for value in (
                [255 * (label == wanted) for wanted in (FOREGROUND, BACKGROUND, CAST_SHADOW)]
                if name == "IDMASK"
                else np.broadcast_to(buffers[name][y, x], 3)
            )
        ]
        assert features[y, x].tolist() == expected
        assert labels[y, x] == label


@pytest.mark.parametrize("packing", [StagePacking(), UnpackedStage()])
def test_bytes_beside_the_features_are_not_written(packing):
    """The image that the search reads has a border, and colours of the style in every pixel."""
    buffers = random_buffers((6, 5))
    channels = len(packing.channels)
    image = np.full((10, 9, channels + 6), 77, np.uint8)
    out = image[2:-2, 2:-2, :channels]
    packing.pack_into(buffers, out)
    np.testing.assert_array_equal(out, pack(packing, buffers)[0])
    beside = np.ones(image.shape, np.bool_)
    beside[2:-2, 2:-2, :channels] = False
    assert (image[beside] == 77).all()


def test_buffers_may_be_views_of_other_arrays():
    buffers = random_buffers((6, 5))
    flipped = {name: np.repeat(buffer, 2, axis=1)[:, ::2] for name, buffer in buffers.items()}
    assert not flipped["FULL"].flags.c_contiguous
    np.testing.assert_array_equal(
        pack(StagePacking(), flipped)[0], pack(StagePacking(), buffers)[0]
    )


def test_every_byte_has_a_buffer_to_be_weighted_by():
    assert len(StagePacking.channels) == 10
    assert set(StagePacking.channels) == set(StagePacking.names)


def test_a_light_mask_in_grey_is_not_taken_for_a_stage():
    grey = np.random.default_rng(1).integers(0, 256, (9, 8, 1), np.uint8)
    buffers = {name: np.repeat(grey, 3, axis=2) for name in STAGE_BUFFERS}
    assert isinstance(choose_packing(buffers), StagePacking)
    assert isinstance(choose_packing({**buffers, "LIGHTMASK": grey}), PrincipalPacking)
