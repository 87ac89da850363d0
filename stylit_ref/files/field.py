"""A nearest-neighbour field and the run it comes from."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from stylit_ref.files.guides.encoding import GuideEncoding


@dataclass(frozen=True, eq=False)
class Field:
    """A nearest-neighbour field, and what :func:`stylit_ref.replay` has to know of its run.

    Attributes
    ----------
    nnf : (H_B, W_B, 2) int32
        From :class:`stylit_ref.Result`; negative where nothing is assigned.
    patch_width : int or None
        None where it is not known.
    vote_outliers : int
        The votes of a pixel that do not count.
    style_size : (H_A, W_A) or None
        Height and width of the run's style; None where they are not known.
    mask : (H_B, W_B) bool or None
        True where the run left the target alone; None without a mask, or where it is not known.
    guide_encodings : tuple of GuideEncoding
        How the run's guides became 8 bits, from :func:`stylit_ref.read_guides`; empty where that is
        not known.
    """

    nnf: NDArray[np.int32]
    patch_width: int | None = None
    vote_outliers: int = 0
    style_size: tuple[int, int] | None = None
    mask: NDArray[np.bool_] | None = None
    guide_encodings: tuple["GuideEncoding", ...] = ()
