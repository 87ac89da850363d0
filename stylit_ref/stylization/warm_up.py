"""Which kernels a run needs, and how to compile them before it."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace

import numpy as np

from stylit_ref import passes
from stylit_ref.machine.compilation import Specialization, compile_missing
from stylit_ref.machine.kernel import rehearsal
from stylit_ref.machine.replaced import replaced
from stylit_ref.parameters import Integer, Several
from stylit_ref.stylization.backends import CPU, Backend
from stylit_ref.stylization.params import Params, as_params
from stylit_ref.stylization.problem import make_synthesis

SIX_GUIDES = (3, 3, 3, 3, 3, 3)
"""Channels of the light passes of Fišer et al. 2016 and of an ID guide, in colour."""

STYLE_CHANNELS = Integer(1, 4)
GUIDE_CHANNELS = Several(Integer(1, 1000), "guide_channels")


def warm_up(
    params: Params | None = None,
    *,
    style_channels: int = 3,
    guide_channels: Sequence[int] = SIX_GUIDES,
    progress: Callable[[int, int], None] | None = None,
) -> int:
    """Compile the CPU's kernels for a run before it, and keep them on disk.

    A run compiles what it lacks by itself: this is for an installation, or a farm's image, whose
    first run shall not wait. The kernels serve every run of the same method, patch width and
    numbers of channels, whatever its other parameters and sizes are.

    Parameters
    ----------
    params : Params, optional
    style_channels : int
        Channels of the style, 1 to 4.
    guide_channels : sequence of int
        Channels of each guide.
    progress : callable, optional
        Called with a kernel's number, from 1, and how many there are to compile, before each.

    Returns
    -------
    int
        How many were compiled: 0 where all were there.

    Raises
    ------
    InputError
        If the parameters and channels do not fit together.
    """
    needed = kernels_of_run(as_params(params), style_channels, guide_channels)
    return compile_missing(needed, progress)


def kernels_of_run(
    params: Params, style_channels: int, guide_channels: Sequence[int]
) -> list[Specialization]:
    """The CPU's kernels that a run calls, found out by a small one in which they do nothing.

    Parameters
    ----------
    params : Params
    style_channels : int
    guide_channels : sequence of int

    Returns
    -------
    list of Specialization
        In the order of their first calls.

    Raises
    ------
    InputError
        If the parameters and channels do not fit together.
    """
    style_channels = STYLE_CHANNELS.check("style_channels", style_channels)
    guide_channels = GUIDE_CHANNELS.check("guide_channels", guide_channels)
    side = 2 * params.patch_width  # two levels, and no array with a side of 1, whose type differs
    black = [np.zeros((side, side, channels), np.uint8) for channels in guide_channels]
    style = np.zeros((side, side, style_channels), np.uint8)
    # λ decides about no kernel, and need not be one that suits such small images.
    short = replace(params, levels=2, votes=1, patchmatch_iterations=1, uniformity=0)
    with rehearsal() as rehearsed:
        make_synthesis(style, black, black, short, backend=rehearsing_backend()).finish()
    return list(rehearsed)


def rehearsing_backend() -> Backend:
    """The CPU, for runs whose kernels do nothing: what they would leave is made up."""
    own = replaced(passes, random_nnf=_first_nnf, energy=_no_energy)
    return CPU._replace(passes=own)


def _first_nnf(nnf, patch_width, *others):
    """Call the kernel that assigns random patches; assign the first one."""
    passes.random_nnf(nnf, patch_width, *others)
    nnf[:] = patch_width // 2


def _no_energy(*arrays):
    """Call the kernels of the energy; they have left nothing to take a mean of."""
    with suppress(ZeroDivisionError):
        passes.energy(*arrays)
    return 0.0, 0.0
