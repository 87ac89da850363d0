"""How close two images are, pixel by pixel."""

from skimage.metrics import peak_signal_noise_ratio, structural_similarity


def psnr(image, reference):
    """Peak signal-to-noise ratio in dB; infinite for equal images.

    Parameters
    ----------
    image, reference : (H, W, n) uint8

    Returns
    -------
    float
    """
    if (image == reference).all():
        return float("inf")
    return float(peak_signal_noise_ratio(reference, image, data_range=255))


def ssim(image, reference):
    """Mean structural similarity over all channels (7x7 windows), up to 1.

    Parameters
    ----------
    image, reference : (H, W, n) uint8

    Returns
    -------
    float
    """
    return float(structural_similarity(reference, image, channel_axis=2, data_range=255))
