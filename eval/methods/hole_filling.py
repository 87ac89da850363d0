"""Holes in an exemplar, filled by the library: what is left, and what each of its cures is for.

The paper fills holes with random coordinates and lets the synthesizer run. Four things are added in
:func:`stylit_ref.texture.complete.complete_texture`; each can be left out here.
"""

import time
from dataclasses import dataclass, replace

import numpy as np
import pandas as pd
from scipy.ndimage import distance_transform_edt, gaussian_filter

from eval.device import processor
from eval.outcome import Outcome
from stylit_ref.machine.code_digest import code_digest
from stylit_ref.texture.complete import VOID
from stylit_ref.texture.formulae.seam_cost import ONE
from stylit_ref.texture.params import TextureParams
from stylit_ref.texture.session import TextureSession

CURES = {
    "centres": "patches lie on a grid, not on the hole",
    "lock": "cuts do not see the lock: seams inside it count, those at its border do not",
    "wrap": "seams across the border of the image count",
    "void": "holes begin with random coordinates, not with the worst seams",
}
"""What is different without each cure."""

_CODE = code_digest(__file__, without=("gpu_cuda",))


def _disc(y, x):
    return np.hypot(y - 0.5, x - 0.5) < 0.126


def _stroke(y, x):
    return (np.abs(y - 0.2 - 0.6 * x - 0.06 * np.sin(9 * x)) < 0.08) & (np.abs(x - 0.5) < 0.42)


def _blobs(y, x):
    rng = np.random.default_rng(5)
    rough = gaussian_filter(rng.normal(size=y.shape), 10)
    rough *= 0.02 / rough.std()
    centres = (0.22, 0.1, 0.18), (0.72, 0.3, 0.16), (0.5, 0.72, 0.165)
    return np.any([np.hypot(y - v, x - u) + rough < r for v, u, r in centres], axis=0)


HOLES = {"disc": _disc, "stroke": _stroke, "blobs": _blobs}
"""Holes of 5, 13 and 25 % of the image; one of the blobs lies at its border."""


def hole_of(name, shape):
    """A hole as a mask.

    Parameters
    ----------
    name : str
        One of :data:`HOLES`.
    shape : tuple of int
        Height and width.

    Returns
    -------
    (height, width) bool
    """
    return HOLES[name](*(np.indices(shape).T / np.array(shape)).T)


class _OnGrid(TextureSession):
    """Cells that do not know where the hole is."""

    def offer(self, texture, predicate):
        canvas, self.canvas = self.canvas, replace(self.canvas, free=None)
        offered = super().offer(texture, predicate)
        self.canvas = canvas
        return offered


class _BlindCuts(TextureSession):
    """Cuts as if no pixel were locked; locked ones are not written all the same."""

    def fitted(self, radius):
        polar, sources, settings = super().fitted(radius)
        return polar, sources, settings._replace(has_lock=0)


_SESSIONS = {"centres": _OnGrid, "lock": _BlindCuts}


@dataclass(frozen=True)
class HoleFilling:
    """A hole in the exemplar, filled with what is known of it.

    Attributes
    ----------
    name : str
        What reports call it.
    hole : str
        One of :data:`HOLES`.
    without : str, optional
        One of :data:`CURES`, to be left out.
    """

    name: str
    hole: str
    without: str | None = None

    cost = 8.0

    @property
    def code(self):
        """Digest of the algorithm."""
        return _CODE

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    def run(self, texture, seed, progress=None):
        """Fill the hole.

        Parameters
        ----------
        texture : Texture
        seed : int
        progress : callable, optional
            Not called: a run takes a second.

        Returns
        -------
        Outcome
            The history has one row: ``hole`` pixels, ``changed`` known pixels, pixels ``left`` as
            they were at the start, ``cost`` of the seams inside the hole and at its border a pixel
            of the hole, and ``iterations``.
        """
        picture = texture.exemplar
        hole = hole_of(self.hole, picture.shape[:2])
        params = TextureParams.preset("complete")
        begun = time.perf_counter()
        session = self._session(picture, hole, params, seed)
        start = session.coordinates
        for _ in range(params.iterations):
            session.step()
        seconds = time.perf_counter() - begun
        image = session.image[..., : picture.shape[2]]
        same = (session.coordinates == start).all(axis=2)
        found = {
            "hole": int(hole.sum()),
            "changed": int((image != picture).any(axis=2)[~hole].sum()),
            "left": int((same & hole).sum()),
            "cost": _cost(session.seams, hole),
            "iterations": session.iteration,
        }
        return Outcome(
            image, seconds, history=pd.DataFrame([found]), coordinates=session.coordinates
        )

    def _session(self, picture, hole, params, seed):
        """As :func:`complete_texture` has it, but for the cure that is left out."""
        nearest = distance_transform_edt(hole, return_distances=False, return_indices=True)
        coloured = np.broadcast_to(picture[tuple(nearest)], (*hole.shape, 3))
        y, x = np.indices(hole.shape)
        start = np.stack([np.zeros_like(y), y * 4, x * 4], axis=-1).astype(np.int32)
        if self.without == "void":
            known = np.argwhere(~hole)
            drawn = np.random.default_rng(seed).integers(0, len(known), int(hole.sum()))
            start[hole, 1:] = 4 * known[drawn]
        else:
            start[hole, 0] = 1
            start[hole, 1] = np.where((y + x)[hole] % 2, 4, 16)
            start[hole, 2] = 0
        return _SESSIONS.get(self.without, TextureSession)(
            [coloured, VOID], hole.shape, params, seed=seed,
            known=[~hole, np.zeros(VOID.shape[:2], np.bool_)], start=start, lock=~hole,
            wraps=self.without in ("wrap", "lock"),
        )  # fmt: skip


def _cost(seams, hole):
    """M of all seams that touch the hole, but for those across the border of the image."""
    along, down = seams
    touched = along[:, :-1][hole[:, :-1] | hole[:, 1:]].sum(dtype=np.int64) + down[:-1][
        hole[:-1] | hole[1:]
    ].sum(dtype=np.int64)
    return float(touched / ONE / hole.sum())
