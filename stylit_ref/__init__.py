"""Illumination-guided, example-based stylization of 3D renderings.

>>> from stylit_ref import Params, read_uint8, stylize, write_image
"""

from stylit_ref.bit_depth import to_uint8
from stylit_ref.errors import InputError
from stylit_ref.image_io import read_image, read_uint8, write_image
from stylit_ref.params import PRESETS, Params
from stylit_ref.profiling import Profile
from stylit_ref.replaying import replay
from stylit_ref.stylization import Result, stylize
from stylit_ref.texture_optimization import Step

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
