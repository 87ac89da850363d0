"""Illumination-guided, example-based stylization of 3D renderings.

>>> from stylit_ref import Params, read_uint8, stylize, write_image
"""

from importlib import import_module

from stylit_ref.errors import InputError
from stylit_ref.machine.profiling import Profile
from stylit_ref.stylization.params import PRESETS, Params
from stylit_ref.stylization.replaying import replay
from stylit_ref.stylization.stylize import Result, stylize
from stylit_ref.stylization.synthesis import Step

__all__ = [
    "PRESETS",
    "InputError",
    "Params",
    "Profile",
    "Result",
    "Step",
    "read_image",
    "read_uint8",
    "replay",
    "stylize",
    "to_uint8",
    "write_image",
]
__version__ = "0.1.0"

_IMAGES = {
    "read_image": "files.read_image",
    "read_uint8": "files.read_image",
    "to_uint8": "files.bit_depth",
    "write_image": "files.write_image",
}


def __getattr__(name):
    """Image files on demand: synthesis itself, on a GPU machine say, needs no OpenImageIO."""
    if name in _IMAGES:
        return getattr(import_module(f"stylit_ref.{_IMAGES[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
