"""A synthesis with passes of one's choice, without the checks of :func:`stylit_ref.stylize`."""

import numpy as np

from stylit_ref.metric.packing import make_packing
from stylit_ref.stylization.checks import fit_levels
from stylit_ref.stylization.synthesis import texture_optimization


def synthesis(style, source_guides, target_guides, params, passes, seed=0):
    """Stylize and leave the result where the passes have it.

    Parameters
    ----------
    style : (H_A, W_A, n) uint8
    source_guides, target_guides : sequence of (H, W, c) uint8
    params : Params
    passes : module
    seed : int

    Returns
    -------
    Level
        The finest.
    """
    size = target_guides[0].shape[:2]
    params = fit_levels(params, style.shape[:2], size)
    channels = [guide.shape[2] for guide in source_guides]
    packing = make_packing(channels, style.shape[2], params.guide_influence, [1.0] * len(channels))
    return texture_optimization(
        passes,
        packing.pack(source_guides, style),
        packing.pack(target_guides),
        np.ones(size, bool),
        packing,
        params,
        seed,
        lambda step: None,
        lambda number, level: None,
    )
