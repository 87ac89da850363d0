"""Which packing suits a scene."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.parameters import Choice
from stylit_ref.realtime.packing.packed import Packing
from stylit_ref.realtime.packing.principal import PrincipalPacking
from stylit_ref.realtime.packing.stage import COLOURED, STAGE_BUFFERS, StagePacking
from stylit_ref.realtime.packing.unpacked import UnpackedStage
from stylit_ref.realtime.params import PACKINGS

_ALIKE = 2
"""Mean difference in 8-bit steps of channels that count as the same: noise and rounding."""

_SAME = ("FULL", 1, 2), ("LDE", 1, 2), ("LDDE", 1, 2), ("LSE", 0, 1)
"""What the thesis leaves out: on its stage the second of these channels is as the first."""


def choose_packing(buffers: Mapping[str, NDArray[np.uint8]], how: str = "auto") -> Packing:
    """What packs a source and its targets.

    Parameters
    ----------
    buffers : mapping of str to (H, W) or (H, W, 3) uint8
        Those of the source.
    how : {"auto", "packed", "all", "pca"}
        ``"packed"`` is :class:`StagePacking`, ``"all"`` is :class:`UnpackedStage`, and ``"pca"``
        is :class:`PrincipalPacking`. ``"auto"`` is the first where the buffers are those of a red
        object on a white stage, and the last otherwise.

    Raises
    ------
    InputError
        If the packing cannot read such buffers.
    """
    how = Choice(PACKINGS).check("packing", how)
    if how == "auto":
        how = "packed" if _is_stage(buffers) else "pca"
    if how == "pca":
        return PrincipalPacking.of_source(buffers)
    missing = [name for name in STAGE_BUFFERS if name not in buffers]
    if missing:
        raise InputError(
            f"is {how!r}, which also needs {', '.join(missing)}; add them, or let it be 'pca'",
            parameter="packing",
        )
    return StagePacking() if how == "packed" else UnpackedStage()


def _is_stage(buffers):
    """Whether the packing of the thesis loses nothing of these buffers."""
    if set(buffers) != set(STAGE_BUFFERS):
        return False
    if any(buffers[name].ndim < 3 or buffers[name].shape[2] < 3 for name in COLOURED):
        return False
    return all(_difference(buffers[name], one, other) < _ALIKE for name, one, other in _SAME)


def _difference(buffer, one, other):
    if buffer.ndim < 3 or buffer.shape[2] < 3:
        return 0.0
    return np.abs(buffer[..., one].astype(int) - buffer[..., other]).mean()
