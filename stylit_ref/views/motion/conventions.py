"""What the vectors of a program mean: one table, and the way from it to canonical fields.

A pair of channels leads to the next frame or to the one before, and each axis has a sign against
the canonical one (x right, y down, added to the pixel).

=========  =============  =============  ========================================
name       first pair     second pair    who writes it
=========  =============  =============  ========================================
blender    before, +x -y  next, -x +y    Blender's Vector pass: previous minus
                                         current, current minus next, y up
nuke       next, +x -y    before, +x -y  Nuke's layers forward and backward, y up
flo        next, +x +y                   ``.flo`` files: Middlebury, Sintel, RAFT
own        next, +x +y                   this project's MOTION; in a file of a
                                         pair, from the first to the second
=========  =============  =============  ========================================

A name may be followed by ``-flip-x``, ``-flip-y`` (the sign of an axis is the other one), ``-swap``
(the first channel is the vertical one) and ``-reverse`` (next and before change places), in this
order. ``flo-flip-x-flip-y`` is current minus next, for instance, and ``flo-reverse`` leads to the
frame before.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product
from typing import NamedTuple

import numpy as np

from stylit_ref.errors import InputError, did_you_mean
from stylit_ref.files.motion_file import BLENDER, FLO, NUKE, OTHER, OWN, Vectors, VectorsLook
from stylit_ref.views.frames import Motion

AUTO = "auto"
NEXT, BEFORE = 1, -1
CHANGES = ("flip-x", "flip-y", "swap", "reverse")


class FrameMotion(NamedTuple):
    """The canonical fields that start at the pixels of one frame.

    Attributes
    ----------
    forward, backward : Motion or None
        Into the next frame, and into the one before. ``visible`` is False where there is no vector
        or the file says that the other frame does not show the point.
    tells_visible : bool
        Whether the file says what the other frame shows; otherwise it has to be found out
        (:mod:`stylit_ref.views.motion.visibility`).
    """

    forward: Motion | None
    backward: Motion | None
    tells_visible: bool = False

    def towards(self, step: int) -> Motion | None:
        """The field into the next frame, ``step`` 1, or into the one before, -1."""
        return self.forward if step == NEXT else self.backward


class Lead(NamedTuple):
    """Where a pair of channels leads.

    Attributes
    ----------
    step : int
        1 to the next frame, -1 to the one before.
    right, down : int
        1 or -1: the sign of the channel against the canonical axis.
    """

    step: int
    right: int
    down: int


@dataclass(frozen=True)
class Convention:
    """What the pairs of channels mean.

    Attributes
    ----------
    name : str
    leads : tuple of Lead
        One for each pair.
    is_swapped : bool
        Whether the first channel of a pair is the vertical one.
    """

    name: str
    leads: tuple[Lead, ...]
    is_swapped: bool = False

    def fields(self, vectors: Vectors) -> FrameMotion:
        """Turn vectors as stored into canonical fields.

        Parameters
        ----------
        vectors : Vectors

        Returns
        -------
        FrameMotion

        Raises
        ------
        InputError
            If the file has another number of pairs than the convention.
        """
        if len(vectors.pairs) != len(self.leads):
            raise InputError(
                f"{self.name} is for vectors of {2 * len(self.leads)} channels, and the file has "
                f"{2 * len(vectors.pairs)}; auto takes what the names of the channels say",
                parameter="convention",
            )
        found: dict[int, Motion] = {}
        for pair, known, lead in zip(vectors.pairs, vectors.known, self.leads, strict=True):
            if pair is not None and known is not None:
                shown = known if vectors.visible is None else known & vectors.visible
                axes = pair[:, :, ::-1] if self.is_swapped else pair
                signs = np.array([lead.right, lead.down], np.float32)
                # Adding 0 makes -0 a 0, so that equal fields have equal bytes.
                found[lead.step] = Motion(axes * signs + np.float32(0), shown)
        return FrameMotion(found.get(NEXT), found.get(BEFORE), vectors.visible is not None)


_LEADS = {
    BLENDER: (Lead(BEFORE, 1, -1), Lead(NEXT, -1, 1)),
    NUKE: (Lead(NEXT, 1, -1), Lead(BEFORE, 1, -1)),
    FLO: (Lead(NEXT, 1, 1),),
    OWN: (Lead(NEXT, 1, 1),),
}
PROGRAMS = tuple(_LEADS)


def _variants(name: str) -> Iterator[Convention]:
    """The convention and all its changes, those with fewer changes first."""
    for chosen in sorted(product((False, True), repeat=len(CHANGES)), key=sum):
        flip_x, flip_y, swap, reverse = chosen
        leads = tuple(
            Lead(
                -lead.step if reverse else lead.step,
                -lead.right if flip_x else lead.right,
                -lead.down if flip_y else lead.down,
            )
            for lead in _LEADS[name]
        )
        changes = [change for change, is_so in zip(CHANGES, chosen, strict=True) if is_so]
        yield Convention("-".join([name, *changes]), leads, swap)


CONVENTIONS = {each.name: each for name in PROGRAMS for each in _variants(name)}
"""All conventions by name: four programs, each with 16 variants."""


def convention_named(name: str) -> Convention:
    """Look a convention up.

    Parameters
    ----------
    name : str

    Returns
    -------
    Convention

    Raises
    ------
    InputError
        If there is none of that name.
    """
    if name in CONVENTIONS:
        return CONVENTIONS[name]
    raise InputError(
        f"is {name!r}; write auto or one of {', '.join(PROGRAMS)}, followed by any of "
        f"{', '.join('-' + change for change in CHANGES)}{did_you_mean(name, CONVENTIONS)}",
        parameter="convention",
    )


def convention_of(vectors: Vectors | VectorsLook, source: str) -> Convention:
    """The convention that the names of file and channels tell.

    Parameters
    ----------
    vectors : Vectors or VectorsLook
    source : str
        The file's name, for the message.

    Returns
    -------
    Convention

    Raises
    ------
    InputError
        If they tell nothing.
    """
    if vectors.dialect != OTHER:
        return CONVENTIONS[vectors.dialect]
    raise InputError(
        f"{source}: the names of its channels do not tell the convention; name it, for instance "
        "flo-flip-y; 'stylit-ref motion check' finds it",
        parameter="convention",
    )
