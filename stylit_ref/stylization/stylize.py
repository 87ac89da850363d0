"""``stylize``: from images to a stylized image in one call."""

from collections.abc import Callable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from stylit_ref.arrays import as_array
from stylit_ref.machine.compilation import compiling_together
from stylit_ref.machine.profiling import Profile
from stylit_ref.machine.thread_count import using_threads
from stylit_ref.metric.packing import ONE
from stylit_ref.stylization.backends import CPU, find_backend
from stylit_ref.stylization.mask import fill_masked
from stylit_ref.stylization.params import Params, as_params
from stylit_ref.stylization.problem import make_synthesis
from stylit_ref.stylization.progress import Step
from stylit_ref.stylization.warm_up import kernels_of_run


@dataclass(frozen=True)
class Result:
    """A stylized image and how it came about.

    Attributes
    ----------
    image : (H_B, W_B) or (H_B, W_B, n) uint8
        The output B', with the style's channels, and those that a mask's fill adds.
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

    image: NDArray[np.uint8]
    nnf: NDArray[np.int32]
    omega: NDArray[np.int32]
    error: NDArray[np.float32]
    history: tuple[Step, ...]
    guide_maps: tuple[NDArray[np.bool_], ...]


def stylize(
    style: NDArray[np.uint8],
    source_guides: Sequence[NDArray[np.uint8]],
    target_guides: Sequence[NDArray[np.uint8]],
    params: Params | None = None,
    *,
    seed: int = 0,
    mask: NDArray[np.bool_] | None = None,
    fill: NDArray[np.uint8] | None = None,
    backend: str = "cpu",
    threads: int | None = None,
    compiling: Callable[[int, int], None] | None = None,
    progress: Callable[[Step], None] | None = None,
    on_level: Callable[[int, NDArray[np.uint8]], None] | None = None,
    profile: Profile | None = None,
) -> Result:
    """Stylize a target by a style exemplar (thesis 2.2).

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
    fill : (H_B, W_B) or (H_B, W_B, n) uint8, optional
        What masked pixels show, 1 to 4 channels; grey is spread to colour beside a style in
        colour, and the other way round. The image has an alpha channel if style or fill has one.
        Without a fill masked pixels are transparent, and the image has an alpha channel.
    backend : {"cpu", "auto", "cuda", "cuda:shared_memory", "cuda:live", "cuda:live_sums"}
        Where to compute. ``auto`` takes a GPU if there is one and the method has kernels.
        All but the last two give the same bytes; ``cuda:shared_memory`` keeps target patches in
        shared memory (thesis 5.1). The ``live`` ones change Ω while their kernels run, as in thesis
        3.3, and no two of their runs are the same.
    threads : int, optional
        Threads to use; all by default, and no more than all. A process that was forked after a run
        has one (:mod:`stylit_ref.machine.forks`).
    compiling : callable, optional
        Called before each kernel that is compiled, with its number, from 1, and how many there are
        to compile. As soon as one is missing, all are compiled, in several processes where that is
        safe; without it, each when it is first called. Kernels of a GPU are not told.
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
    params = as_params(params)
    found = find_backend(backend, params)
    on_cpu = found is CPU
    if profile:
        found = found._replace(passes=profile.passes(found.passes))
    history, guide_maps = [], []
    together = nullcontext()
    if compiling and on_cpu:
        channels = _channels(style), tuple(map(_channels, source_guides))
        together = compiling_together(lambda: kernels_of_run(params, *channels), compiling)
    with using_threads(threads), together:
        synthesis = make_synthesis(
            style, source_guides, target_guides, params,
            seed=seed, mask=mask, fill=fill, backend=found, forgets=True,
        )  # fmt: skip
        is_grey = np.ndim(style) == 2
        del style, source_guides, target_guides  # the synthesis has them in its own layout
        download = found.passes.download
        for number in synthesis.level_numbers:
            for step in synthesis.run_level(number):
                history.append(step)
                if progress:
                    progress(step)
            if params.traits.has_guide_map:
                guide_maps.append(download(synthesis.level.textures.guide_map))
            if on_level:
                on_level(number, _shaped(synthesis.level.style, is_grey))
    finest = synthesis.level
    image, synthesized = np.ascontiguousarray(finest.style), finest.target.synthesized
    nnf, omega, delta = map(download, (finest.nnf, finest.omega, finest.delta))
    del synthesis, finest  # pyramids and moments make room for the result
    if mask is not None:
        filling = None if fill is None else as_array(fill, "fill")
        image = fill_masked(image, as_array(mask, "mask"), filling)
    return Result(
        image=_shaped(image, is_grey),
        nnf=nnf,
        omega=omega,
        error=np.where(synthesized, delta / ONE, np.nan).astype(np.float32),
        history=tuple(history),
        guide_maps=tuple(guide_maps),
    )


def _channels(image):
    return np.shape(image)[2] if np.ndim(image) == 3 else 1


def _shaped(image, is_grey):
    """Copy an (H, W, n) image out of its texture, without the last axis beside a 2-D style."""
    image = np.ascontiguousarray(image)
    return image[:, :, 0] if is_grey and image.shape[2] == 1 else image
