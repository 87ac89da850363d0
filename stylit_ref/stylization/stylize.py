"""``stylize``: from images to a stylized image, with everything checked at the door."""

from collections.abc import Callable, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from numbers import Integral

import numba
import numpy as np

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError
from stylit_ref.machine.profiling import Profile
from stylit_ref.metric.packing import ONE, make_packing
from stylit_ref.stylization.backends import passes_of
from stylit_ref.stylization.checks import (
    as_image,
    check_guides,
    check_mask,
    check_range,
    fit_levels,
)
from stylit_ref.stylization.mask import active_patches, fill_masked
from stylit_ref.stylization.params import Params
from stylit_ref.stylization.synthesis import Step, texture_optimization


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
        Energy after every PatchMatch iteration or retrieval.
    guide_maps : tuple of (H, W) bool
        The guide map of every level, the coarsest first; empty for the other methods.
    """

    image: np.ndarray
    nnf: np.ndarray
    omega: np.ndarray
    error: np.ndarray
    history: tuple[Step, ...]
    guide_maps: tuple[np.ndarray, ...]


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
    profile: Profile | None = None,
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
    backend : {"cpu", "cuda", "auto"}
        Where to compute; the bytes are the same. ``auto`` takes a GPU if there is one for the
        method.
    threads : int, optional
        Threads to use; all by default.
    progress : callable, optional
        Called with a :class:`Step` after every PatchMatch iteration or retrieval.
    on_level : callable, optional
        Called with the level's number and its image when a pyramid level is done.
    profile : Profile, optional
        Accounts for the time by stage.

    Returns
    -------
    Result

    Raises
    ------
    InputError
        If arrays or parameters do not fit together; the message names the sizes.
    """
    params = params or Params()
    passes = passes_of(backend, params)
    passes = profile.passes(passes) if profile else passes
    if not isinstance(seed, Integral) or not 0 <= seed < 1 << 64:
        raise InputError(f"seed is {seed}; it must be an integer from 0 to 2**64 - 1")

    style_image = as_image(style, "style")
    if style_image.shape[2] > 4:
        raise InputError(f"style has {style_image.shape[2]} channels; it must have 1 to 4")
    sources = [as_image(guide, f"source guide {k}") for k, guide in enumerate(source_guides, 1)]
    targets = [as_image(guide, f"target guide {k}") for k, guide in enumerate(target_guides, 1)]
    check_guides(style_image, sources, targets)
    guide_weights = params.guide_weights
    if guide_weights is None:
        guide_weights = (1.0,) * len(sources)
    if params.method == "stylit":
        params = replace(params, uniformity=0)  # the error budget takes its place
    if len(guide_weights) != len(sources):
        raise InputError(f"there are {len(guide_weights)} guide weights for {len(sources)} guides")

    source_size, target_size = style_image.shape[:2], targets[0].shape[:2]
    masked = mask is not None
    mask = as_array(mask, "mask") if masked else np.zeros(target_size, bool)
    check_mask(mask, fill, target_size, style_image.shape[2])
    params = fit_levels(params, source_size, target_size)
    packing = make_packing(
        [guide.shape[2] for guide in sources],
        style_image.shape[2],
        params.guide_influence,
        guide_weights,
    )
    synthesized = active_patches(mask, params.patch_width)
    check_range(packing, params, source_size, int(np.count_nonzero(synthesized)))

    history, guide_maps = [], []

    def on_step(step):
        history.append(step)
        if progress:
            progress(step)

    def report_level(number, level):
        if params.method == "guide_map":
            guide_maps.append(passes.download(level.textures.guide_map))
        if on_level:
            on_level(number, _shaped_like(style, level.style))

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
    image = fill_masked(finest.style, mask, fill) if masked else finest.style
    return Result(
        image=_shaped_like(style, image),
        nnf=passes.download(finest.nnf),
        omega=passes.download(finest.omega),
        error=np.where(synthesized, passes.download(finest.delta) / ONE, np.nan).astype(np.float32),
        history=tuple(history),
        guide_maps=tuple(guide_maps),
    )


def _shaped_like(style, image):
    """Copy an (H, W, n) image out of its texture, without the last axis for a 2-D style."""
    image = np.ascontiguousarray(image)
    return image[:, :, 0] if np.ndim(style) == 2 and image.shape[2] == 1 else image


@contextmanager
def _threads(threads):
    available = numba.config.NUMBA_NUM_THREADS
    if threads is None:
        yield
        return
    if not isinstance(threads, Integral) or not 1 <= threads <= available:
        raise InputError(f"threads is {threads}; this machine offers 1 to {available}")
    before = numba.get_num_threads()
    numba.set_num_threads(threads)
    try:
        yield
    finally:
        numba.set_num_threads(before)
