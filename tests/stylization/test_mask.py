import numpy as np

from stylit_ref.stylization.mask import downsample_mask


def test_mask_keeps_every_pixel_that_has_a_descendant():
    synthesized = np.zeros((7, 6), bool)
    synthesized[6, 0] = synthesized[1, 4] = True
    expected = np.zeros((3, 3), bool)
    expected[2, 0] = expected[0, 2] = True
    np.testing.assert_array_equal(downsample_mask(synthesized), expected)
