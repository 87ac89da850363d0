"""From images to a run that is checked and can begin."""

import logging
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError
from stylit_ref.metric.packing import make_packing
from stylit_ref.notes import note
from stylit_ref.stylization.backends import CPU, Backend
from stylit_ref.stylization.checks import (
    as_image,
    check_fill,
    check_guides,
    check_mask,
    check_source_guides,
    check_target_guides,
    fit_levels,
)
from stylit_ref.stylization.exemplar import Exemplar
from stylit_ref.stylization.mask import active_patches
from stylit_ref.stylization.params import Params, as_params
from stylit_ref.stylization.synthesis import Synthesis
from stylit_ref.stylization.target import Target


def make_exemplar(
    style: NDArray[np.uint8],
    source_guides: Sequence[NDArray[np.uint8]],
    params: Params | None = None,
    *,
    backend: Backend = CPU,
) -> Exemplar:
    """Check a style and its guides, and lay them out for any number of targets and runs.

    Parameters
    ----------
    style, source_guides
        As for :func:`stylit_ref.stylize`.
    params : Params, optional
        Its patch width, guide influence and weights count.
    backend : Backend

    Returns
    -------
    Exemplar

    Raises
    ------
    InputError
        If arrays or parameters do not fit together; the message names the sizes.
    """
    params = as_params(params)
    style, sources = _style(style), _guides(source_guides, "source_guides")
    check_source_guides(style, sources)
    weights = params.guide_weights
    if weights is None:
        weights = (1.0,) * len(sources)
    if len(weights) != len(sources):
        raise InputError(
            f"holds {len(weights)} weights for {len(sources)} guides; each guide needs one",
            parameter="guide_weights",
        )
    if not any(weights):
        note(
            "is 0 for every guide, so the guides guide nothing",
            parameter="guide_weights",
            level=logging.WARNING,
        )
    sizes = [guide.shape[2] for guide in sources]
    packing = make_packing(sizes, style.shape[2], params.guide_influence, weights)
    texture = packing.pack(sources, style)
    return Exemplar(backend.passes, packing, params.patch_width, texture)


def make_target(
    target_guides: Sequence[NDArray[np.uint8]],
    exemplar: Exemplar,
    *,
    mask: NDArray[np.bool_] | None = None,
) -> Target:
    """Check the guides of a target, and lay them out for an exemplar like this one.

    Parameters
    ----------
    target_guides, mask
        As for :func:`stylit_ref.stylize`.
    exemplar : Exemplar

    Returns
    -------
    Target

    Raises
    ------
    InputError
        If arrays do not fit together; the message names the sizes.
    """
    targets = _guides(target_guides, "target_guides")
    check_target_guides(targets, exemplar.packing.guide_sizes)
    size = targets[0].shape[:2]
    mask = np.zeros(size, bool) if mask is None else as_array(mask, "mask")
    check_mask(mask, size)
    texture, width = exemplar.packing.pack(targets), exemplar.patch_width
    return Target(exemplar.passes, exemplar.packing, width, texture, active_patches(mask, width))


def make_synthesis(
    style: NDArray[np.uint8],
    source_guides: Sequence[NDArray[np.uint8]],
    target_guides: Sequence[NDArray[np.uint8]],
    params: Params | None = None,
    *,
    seed: int = 0,
    mask: NDArray[np.bool_] | None = None,
    fill: NDArray[np.uint8] | None = None,
    backend: Backend = CPU,
    forgets: bool = False,
) -> Synthesis:
    """Check images and parameters, and lay them out for a run.

    Parameters
    ----------
    style, source_guides, target_guides, params, seed, mask, fill
        As for :func:`stylit_ref.stylize`; ``fill`` is checked alone.
    backend : Backend
        From :func:`stylit_ref.stylization.backends.find_backend`.
    forgets : bool
        Whether each level can be begun once only, which takes less memory.

    Returns
    -------
    Synthesis
        Before its first level.

    Raises
    ------
    InputError
        If arrays or parameters do not fit together; the message names the sizes.
    """
    params = as_params(params)
    style, sources = _style(style), _guides(source_guides, "source_guides")
    targets = _guides(target_guides, "target_guides")
    check_guides(style, sources, targets)
    size = targets[0].shape[:2]
    if fill is not None:
        check_fill(as_image(fill, "fill"), size)
    params = fit_levels(params, style.shape[:2], size)
    exemplar = make_exemplar(style, sources, params, backend=backend)
    target = make_target(targets, exemplar, mask=mask)
    return Synthesis(exemplar, target, params, seed, backend.iterate, forgets)


def _style(style):
    style = as_image(style, "style")
    if style.shape[2] > 4:
        raise InputError(f"has {style.shape[2]} channels; it must have 1 to 4", parameter="style")
    return style


def _guides(guides, parameter):
    if isinstance(guides, np.ndarray):
        one = parameter.removesuffix("s")
        raise InputError(
            f"is one array of shape {guides.shape}; put it in a list: [{one}]", parameter=parameter
        )
    return [as_image(guide, f"{parameter}[{k}]") for k, guide in enumerate(guides)]
