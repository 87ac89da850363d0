"""From images to a run that can begin, with everything checked at the door."""

from collections.abc import Sequence
from numbers import Integral

import numpy as np

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError
from stylit_ref.metric.packing import make_packing
from stylit_ref.stylization.backends import CPU, Backend
from stylit_ref.stylization.checks import (
    as_image,
    check_guides,
    check_mask,
    check_range,
    fit_levels,
)
from stylit_ref.stylization.exemplar import Exemplar
from stylit_ref.stylization.mask import active_patches
from stylit_ref.stylization.params import Params
from stylit_ref.stylization.synthesis import Synthesis
from stylit_ref.stylization.target import Target


def make_synthesis(
    style: np.ndarray,
    source_guides: Sequence[np.ndarray],
    target_guides: Sequence[np.ndarray],
    params: Params | None = None,
    *,
    seed: int = 0,
    mask: np.ndarray | None = None,
    fill: np.ndarray | None = None,
    backend: Backend = CPU,
) -> Synthesis:
    """Check images and parameters, and lay them out for a run.

    Parameters
    ----------
    style, source_guides, target_guides, params, seed, mask, fill
        As for :func:`stylit_ref.stylize`; ``fill`` is checked alone.
    backend : Backend
        From :func:`stylit_ref.stylization.backends.find_backend`.

    Returns
    -------
    Synthesis
        Before its first level.

    Raises
    ------
    InputError
        If arrays or parameters do not fit together; the message names the sizes.
    """
    params = params or Params()
    if not isinstance(seed, Integral) or not 0 <= seed < 1 << 64:
        raise InputError(f"is {seed}; it must be an integer from 0 to 2**64 - 1", parameter="seed")
    style = as_image(style, "style")
    if style.shape[2] > 4:
        raise InputError(f"style has {style.shape[2]} channels; it must have 1 to 4")
    sources = [as_image(guide, f"source guide {k}") for k, guide in enumerate(source_guides, 1)]
    targets = [as_image(guide, f"target guide {k}") for k, guide in enumerate(target_guides, 1)]
    check_guides(style, sources, targets)
    guide_weights = params.guide_weights
    if guide_weights is None:
        guide_weights = (1.0,) * len(sources)
    if len(guide_weights) != len(sources):
        raise InputError(f"there are {len(guide_weights)} guide weights for {len(sources)} guides")

    source_size, target_size = style.shape[:2], targets[0].shape[:2]
    mask = np.zeros(target_size, bool) if mask is None else as_array(mask, "mask")
    check_mask(mask, fill, target_size, style.shape[2])
    params = fit_levels(params, source_size, target_size)
    packing = make_packing(
        [guide.shape[2] for guide in sources], style.shape[2], params.guide_influence, guide_weights
    )
    synthesized = active_patches(mask, params.patch_width)
    check_range(packing, params, source_size, int(np.count_nonzero(synthesized)))

    passes, width = backend.passes, params.patch_width
    exemplar = Exemplar(passes, packing, width, packing.pack(sources, style))
    target = Target(passes, packing, width, packing.pack(targets), synthesized)
    return Synthesis(exemplar, target, params, seed, backend.iterate)
