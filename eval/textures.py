"""Exemplars, and the textures to synthesize from them: what scenes are to stylization."""

import hashlib
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import skimage.data

from data_gen.textures import TEXTURES, make_texture
from stylit_ref import InputError

PHOTOGRAPHS = {"brick": (256, 0), "grass": (0, 0), "gravel": (0, 0)}
"""Photographs that scikit-image brings along (CC0), and the corner of the 256² pixels taken."""

NINE = ("bricks", "canes", "flowers", "pebbles", "glyphs", "marble", *PHOTOGRAPHS)
"""The exemplars of every table; the door is left out, since no patch can keep it whole."""


@dataclass(frozen=True)
class Texture:
    """A texture to synthesize.

    Attributes
    ----------
    name : str
        That of the exemplar.
    exemplar : (H, W, c) uint8
        1 or 3 channels.
    shape : tuple of int
        Height and width of the texture.
    """

    name: str
    exemplar: np.ndarray
    shape: tuple[int, int] = (512, 512)

    digest_of_ids = "-" * 8
    """There are no object ids."""

    @property
    def size(self):
        """Width and height of the texture as text."""
        return "{1}x{0}".format(*self.shape)

    @property
    def pixels(self):
        """Pixels of the texture."""
        return self.shape[0] * self.shape[1]

    @cached_property
    def digest(self):
        """Identifies what methods see."""
        seen = f"{self.exemplar.shape} {self.shape}".encode()
        return hashlib.sha256(seen + self.exemplar.tobytes()).hexdigest()


def load_texture(name, shape=(512, 512)):
    """A texture to synthesize from an exemplar of ours or a photograph.

    Parameters
    ----------
    name : str
        One of :data:`data_gen.textures.TEXTURES` or :data:`PHOTOGRAPHS`.
    shape : tuple of int
        Height and width of the texture.

    Returns
    -------
    Texture

    Raises
    ------
    InputError
        If there is no such exemplar.
    """
    if name in TEXTURES:
        return Texture(name, make_texture(name), shape)
    if name not in PHOTOGRAPHS:
        known = ", ".join([*TEXTURES, *PHOTOGRAPHS])
        raise InputError(f"{name}: is no exemplar; choose from {known}")
    top, left = PHOTOGRAPHS[name]
    image = getattr(skimage.data, name)()[top : top + 256, left : left + 256]
    return Texture(name, np.ascontiguousarray(image[:, :, None]), shape)


def large_texture(name, shape):
    """A texture to complete: an exemplar of ours that is as large as it.

    Parameters
    ----------
    name : str
        One of :data:`data_gen.textures.TEXTURES`.
    shape : tuple of int
        Height and width.

    Returns
    -------
    Texture
    """
    exemplar = make_texture(name, max(shape))[: shape[0], : shape[1]]
    return Texture(name, np.ascontiguousarray(exemplar), shape)
