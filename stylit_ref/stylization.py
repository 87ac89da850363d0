"""``stylize``: from images to a stylized image, with everything checked at the door."""

import warnings
from collections.abc import Callable, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace

import numba
import numpy as np

from stylit_ref import passes
from stylit_ref.errors import InputError
from stylit_ref.mask import active_patches, fill_masked
from stylit_ref.packing import ONE, Packing, make_packing, occurrence_weight
from stylit_ref.params import Params
from stylit_ref.texture_optimization import Step, texture_optimization


@dataclass(frozen=True)
class Result:
    """A stylized image and how it came about.

    Attributes
    ----------
    image : (H_B, W_B) or (H_B, W_B, n) uint8
        The output B', shaped like the style.
    nnf : (H_B, W_B, 2) int32
        For each target pixel the centre ``(y, x)`` of its source patch; -1 where a
        mask leaves the pixel alone.
    omega : (H_A, W_A) int32
        Ω, the number of assigned patches that cover each source pixel.
    error : (H_B, W_B) float32
        δ between each target patch of the finished image and its source patch, in
        squared 8-bit steps; NaN where a mask leaves the pixel alone.
    history : tuple of Step
        Energy after every PatchMatch iteration.
    """

    image: np.ndarray
    nnf: np.ndarray
    omega: np.ndarray
    error: np.ndarray
    history: tuple[Step, ...]


def stylize(
    style: np.ndarray,
    source_guides: Sequence[np.ndarray],
    target_guides: Sequence[np.ndarray],
    params: Params | None = None,
    *,
    seed: int = 0,
    mask: np.ndarray | None = None,
    fill: np.ndarray | None = None,
    backend: str = "cpu",
    threads: int | None = None,
    progress: Callable[[Step], None] | None = None,
    on_level: Callable[[int, np.ndarray], None] | None = None,
) -> Result:
    """Stylize a target as a style exemplar shows (thesis 2.2).

    The same arguments give the same bytes, whatever the number of threads.

    Parameters
    ----------
    style : (H_A, W_A) or (H_A, W_A, n) uint8
        The style exemplar A', 1 to 4 channels.
    source_guides : sequence of (H_A, W_A) or (H_A, W_A, c) uint8
        Guidance A: renderings of the scene the artist painted over, any number of
        channels.
    target_guides : sequence of (H_B, W_B) or (H_B, W_B, c) uint8
        Guidance B: the same renderings of the target, in the same order.
    params : Params, optional
    seed : int
        From 0 to 2**64 - 1.
    mask : (H_B, W_B) bool, optional
        True where the target is left alone. No source patch is spent there.
    fill : array like the output, optional
        What masked pixels show; without it they are transparent and the image gains
        an alpha channel if the style has none.
    backend : {"cpu"}
    threads : int, optional
        Threads to use; all by default.
    progress : callable, optional
        Called with a :class:`Step` after every PatchMatch iteration.
    on_level : callable, optional
        Called with the level's number and its image when a pyramid level is done.

    Returns
    -------
    Result

    Raises
    ------
    InputError
        If arrays or parameters do not fit together; the message names the sizes.
    """
    params = params or Params()
    if backend != "cpu":
        raise InputError(f"backend is {backend!r}; only 'cpu' is available")
    if not 0 <= seed < 1 << 64:
        raise InputError(f"seed is {seed}; it must be from 0 to 2**64 - 1")

    style_image = _as_image(style, "style")
    if style_image.shape[2] > 4:
        raise InputError(f"style has {style_image.shape[2]} channels; it must have 1 to 4")
    sources = [_as_image(guide, f"source guide {k}") for k, guide in enumerate(source_guides, 1)]
    targets = [_as_image(guide, f"target guide {k}") for k, guide in enumerate(target_guides, 1)]
    _check_guides(style_image, sources, targets)
    guide_weights = params.guide_weights or (1.0,) * len(sources)
    if len(guide_weights) != len(sources):
        raise InputError(f"there are {len(guide_weights)} guide weights for {len(sources)} guides")

    source_size, target_size = style_image.shape[:2], targets[0].shape[:2]
    if mask is None:
        mask = np.zeros(target_size, bool)
    _check_mask(mask, fill, target_size, style_image.shape[2])
    params = _fit_levels(params, source_size, target_size)
    packing = make_packing(
        [guide.shape[2] for guide in sources],
        style_image.shape[2],
        params.guide_influence,
        guide_weights,
    )
    synthesized = active_patches(mask, params.patch_width)
    _check_range(packing, params, source_size, int(np.count_nonzero(synthesized)))

    history = []

    def on_step(step):
        history.append(step)
        if progress:
            progress(step)

    def report_level(level, packed_style):
        if on_level:
            on_level(level, _shaped_like(style, packed_style))

    with _threads(threads):
        finest = texture_optimization(
            passes,
            packing.pack(sources, style_image),
            packing.pack(targets),
            synthesized,
            packing,
            params,
            seed,
            on_step,
            report_level,
        )
    image = fill_masked(finest.style, mask, fill) if mask.any() else finest.style
    return Result(
        image=_shaped_like(style, image),
        nnf=finest.nnf,
        omega=finest.omega,
        error=np.where(synthesized, finest.delta / ONE, np.nan).astype(np.float32),
        history=tuple(history),
    )


def size(shape):
    """``width x height`` of an array shape, as images are spoken of."""
    return f"{shape[1]}x{shape[0]}"


def _as_image(array, name):
    array = np.asarray(array)
    if array.dtype != np.uint8:
        raise InputError(
            f"{name} has dtype {array.dtype}; it must be uint8 (image_io.to_uint8 converts)"
        )
    if array.ndim == 2:
        array = array[:, :, None]
    if array.ndim != 3 or 0 in array.shape:
        raise InputError(f"{name} has shape {array.shape}; it must be (H, W) or (H, W, channels)")
    return array


def _shaped_like(style, image):
    """Copy an (H, W, n) image out of its texture, without the last axis for a 2-D style."""
    image = np.ascontiguousarray(image)
    return image[:, :, 0] if np.ndim(style) == 2 and image.shape[2] == 1 else image


def _check_guides(style, sources, targets):
    if len(sources) != len(targets):
        raise InputError(
            f"there are {len(sources)} source guides and {len(targets)} target guides; "
            "each source guide needs its target"
        )
    if not sources:
        raise InputError("there are no guides; at least one pair is needed")
    for k, (source, target) in enumerate(zip(sources, targets, strict=True), 1):
        if source.shape[:2] != style.shape[:2]:
            raise InputError(
                f"source guide {k} is {size(source.shape)} but the style is "
                f"{size(style.shape)}; they must have the same size"
            )
        if target.shape[:2] != targets[0].shape[:2]:
            raise InputError(
                f"target guide {k} is {size(target.shape)} but target guide 1 is "
                f"{size(targets[0].shape)}; they must have the same size"
            )
        if source.shape[2] != target.shape[2]:
            raise InputError(
                f"source guide {k} has {source.shape[2]} channels and target guide {k} has "
                f"{target.shape[2]}; they must have the same number"
            )


def _check_mask(mask, fill, target_size, style_channels):
    if mask.dtype != bool or mask.shape != target_size:
        raise InputError(
            f"mask is {mask.dtype} of shape {mask.shape}; "
            f"it must be bool of the target's shape {target_size}"
        )
    if mask.all():
        raise InputError("the mask leaves the whole target alone; nothing is to be synthesized")
    if fill is None:
        return
    fill = _as_image(fill, "fill")
    if fill.shape != (*target_size, style_channels):
        raise InputError(
            f"fill is {size(fill.shape)} with {fill.shape[2]} channels; it must be "
            f"{size(target_size)} with the style's {style_channels}"
        )


def _fit_levels(params, source_size, target_size):
    """Fewer levels where the coarsest would be smaller than a patch."""
    for name, shape in (("source", source_size), ("target", target_size)):
        if min(shape) < params.patch_width:
            raise InputError(
                f"patch_width is {params.patch_width} but the {name} is {size(shape)}; "
                "a patch must fit into the image"
            )
    levels, shortest = 1, min(*source_size, *target_size)
    while shortest >> levels >= params.patch_width and levels < params.levels:
        levels += 1
    if levels < params.levels:
        warnings.warn(
            f"{levels} pyramid levels in place of {params.levels}: "
            f"a coarser one would be smaller than a patch",
            stacklevel=3,
        )
    return replace(params, levels=levels)


def _check_range(packing: Packing, params, source_size, target_patches):
    """The integers of the metric must fit: W 32 bits; φ, times the pixels of a patch, 64."""
    patch_pixels = params.patch_width**2
    if target_patches * patch_pixels >= 1 << 31:
        raise InputError(
            f"{target_patches} target patches of {patch_pixels} pixels overflow the occurrence "
            f"map; at most {(1 << 31) // patch_pixels} patches of that width are possible"
        )
    source_pixels = source_size[0] * source_size[1]
    weight = occurrence_weight(params.uniformity, params.patch_width, source_pixels, target_patches)
    largest_delta = patch_pixels * 255**2 * int(packing.weights.sum())
    largest_phi = weight * patch_pixels * target_patches + largest_delta
    if largest_phi * patch_pixels >= 1 << 62:
        raise InputError(
            f"uniformity {params.uniformity:g} with guide influence {params.guide_influence:g} "
            "overflows 64-bit integers on images of this size; choose smaller ones"
        )


@contextmanager
def _threads(threads):
    available = numba.config.NUMBA_NUM_THREADS
    if threads is None:
        yield
        return
    if not 1 <= threads <= available:
        raise InputError(f"threads is {threads}; this machine offers 1 to {available}")
    before = numba.get_num_threads()
    numba.set_num_threads(threads)
    try:
        yield
    finally:
        numba.set_num_threads(before)
