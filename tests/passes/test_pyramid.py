import numpy as np

from stylit_ref import passes


def test_downsample_is_the_mean_rounded_half_up():
    rng = np.random.default_rng(0)
    image = rng.integers(0, 256, (9, 12, 16), dtype=np.uint8)
    blocks = image[:8].reshape(4, 2, 6, 2, 16).astype(float)
    expected = np.floor(blocks.mean(axis=(1, 3)) + 0.5)
    np.testing.assert_array_equal(passes.downsample(image), expected)


def test_downsample_rounds_half_up():
    image = np.array([0, 0, 1, 1], np.uint8).reshape(2, 2, 1)
    assert passes.downsample(image)[0, 0, 0] == 1


def test_upsampled_nnf_doubles_and_keeps_the_offset():
    coarse = np.stack(np.mgrid[3:6, 4:8], axis=-1).astype(np.int32)
    fine = np.zeros((7, 8, 2), np.int32)
    passes.upsample_nnf(coarse, fine, 5, 40, 40)
    expected = np.stack(np.mgrid[6:13, 8:16], axis=-1)
    np.testing.assert_array_equal(fine, expected)


def test_upsampled_nnf_stays_inside_and_leaves_masked_pixels():
    coarse = np.full((2, 2, 2), 7, np.int32)
    fine = np.zeros((5, 4, 2), np.int32)
    fine[0, 0] = -1
    passes.upsample_nnf(coarse, fine, 5, 16, 15)
    assert (fine[0, 0] == -1).all()
    assert fine[..., 0].max() == 13
    assert fine[..., 1].max() == 12


def test_random_nnf_is_uniform_over_centres():
    nnf = np.zeros((200, 200, 2), np.int32)
    stream = tuple(np.uint32(word) for word in (0, 0, 1, 0))
    passes.random_nnf(nnf, 5, 9, 12, stream)
    counts = np.zeros((9, 12), int)
    np.add.at(counts, (nnf[..., 0], nnf[..., 1]), 1)
    assert (counts[2:7, 2:10] > 800).all()
    assert counts.sum() == counts[2:7, 2:10].sum()
