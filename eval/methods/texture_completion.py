"""Texture completion of the library itself, and textures from several exemplars."""

import time
from dataclasses import dataclass

import numpy as np

from eval.device import processor
from eval.outcome import Outcome
from eval.textures import load_texture
from stylit_ref.machine.code_digest import code_digest
from stylit_ref.texture.complete import complete_texture
from stylit_ref.texture.synthesize import synthesize_texture

_CODE = code_digest(__file__, without=("gpu_cuda",))


@dataclass(frozen=True)
class TextureCompletion:
    """A run of :func:`stylit_ref.texture.complete.complete_texture` on an exemplar.

    Attributes
    ----------
    name : str
        What reports call it.
    inverted : bool
        Whether what :func:`holes` shows is kept, and all else is filled.
    """

    name: str
    inverted: bool

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
        """Fill the holes; as :meth:`eval.methods.texture.TextureSynthesis.run`."""
        hole = holes(texture.exemplar.shape[:2]) ^ self.inverted
        begun = time.perf_counter()
        result = complete_texture(texture.exemplar, hole, seed=seed)
        seconds = time.perf_counter() - begun
        return Outcome(result.image, seconds, coordinates=result.coordinates)


@dataclass(frozen=True)
class LabelledTexture:
    """A texture from two exemplars; a label map says where each is.

    Attributes
    ----------
    name : str
        What reports call it.
    other : str
        The exemplar where :func:`holes` shows; that of the texture is everywhere else.
    """

    name: str
    other: str

    cost = 2.0

    @property
    def code(self):
        """Digest of the algorithm."""
        return _CODE

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    def run(self, texture, seed, progress=None):
        """Synthesize it; as :meth:`eval.methods.texture.TextureSynthesis.run`."""
        exemplars = [texture.exemplar, load_texture(self.other).exemplar]
        labels = 1 + holes(texture.shape).astype(np.uint8)
        begun = time.perf_counter()
        result = synthesize_texture(exemplars, texture.shape, seed=seed, labels=labels)
        seconds = time.perf_counter() - begun
        return Outcome(result.image, seconds, coordinates=result.coordinates)


def holes(shape):
    """A mask of two discs and a stroke, a quarter of the picture.

    Parameters
    ----------
    shape : tuple of int
        Height and width.

    Returns
    -------
    (height, width) bool
    """
    y, x = (np.indices(shape).T / np.array(shape)).T
    discs = np.hypot(y - 0.3, x - 0.32) < 0.2
    discs |= np.hypot(y - 0.7, x - 0.75) < 0.14
    return discs | ((abs(y - 0.8 + 0.2 * x) < 0.04) & (x < 0.55) & (x > 0.08))
