"""Illumination-guided, example-based stylization of 3D renderings.

>>> from stylit_ref import Params, read_uint8, stylize, write_image

and texture synthesis by patches:

>>> from stylit_ref import TextureParams, synthesize_texture

and stylization in real time:

>>> from stylit_ref import RealtimeSession, StagePacking

and views or sequences that do not flicker, and views between them:

>>> from stylit_ref import Coherence, Motion, stylize_frames, stylize_views, views_of_run
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from stylit_ref.errors import InputError
    from stylit_ref.files.colour.bit_depth import to_uint8
    from stylit_ref.files.field import Field
    from stylit_ref.files.guides.encoding import GuideEncoding
    from stylit_ref.files.guides.read_guides import Guides, read_guides
    from stylit_ref.files.nnf_file import read_nnf, write_nnf
    from stylit_ref.files.read_image import read_image, read_uint8
    from stylit_ref.files.realtime_field import (
        RealtimeField,
        read_any_field,
        write_realtime_field,
    )
    from stylit_ref.files.texture_field import (
        TextureField,
        read_texture_field,
        write_texture_field,
    )
    from stylit_ref.files.write_image import write_image
    from stylit_ref.machine.profiling import Profile
    from stylit_ref.realtime.packing.choose import choose_packing
    from stylit_ref.realtime.packing.packed import pack
    from stylit_ref.realtime.packing.principal import PrincipalPacking
    from stylit_ref.realtime.packing.stage import StagePacking
    from stylit_ref.realtime.params import REALTIME_PRESETS, RealtimeParams
    from stylit_ref.realtime.replaying import replay_realtime
    from stylit_ref.realtime.session import FrameCancelledError, RealtimeSession
    from stylit_ref.stylization.params import PRESETS, Params
    from stylit_ref.stylization.progress import Step
    from stylit_ref.stylization.replaying import replay
    from stylit_ref.stylization.stylize import Result, stylize
    from stylit_ref.stylization.warm_up import warm_up
    from stylit_ref.texture.complete import complete_texture, make_tileable
    from stylit_ref.texture.dragging import DraggedPatch, drag, drop
    from stylit_ref.texture.iteration import Iteration
    from stylit_ref.texture.overlay import overlay
    from stylit_ref.texture.painting import paint
    from stylit_ref.texture.params import TEXTURE_PRESETS, TextureParams
    from stylit_ref.texture.replaying import replay_texture
    from stylit_ref.texture.session import TextureSession
    from stylit_ref.texture.synthesize import TextureResult, synthesize_texture
    from stylit_ref.views.file_shot import FileShot
    from stylit_ref.views.frame_result import FrameResult
    from stylit_ref.views.frame_step import FrameStep
    from stylit_ref.views.frames import Motion, grid_pairs, sequence_pairs
    from stylit_ref.views.interpolation.of_run import views_of_run
    from stylit_ref.views.interpolation.view_interpolator import ViewInterpolator
    from stylit_ref.views.motion.between import motion_between
    from stylit_ref.views.motion.conventions import FrameMotion
    from stylit_ref.views.motion.reading import read_motion
    from stylit_ref.views.params import Coherence
    from stylit_ref.views.replaying import ReplayedFrame, replay_run
    from stylit_ref.views.run_folder import Run
    from stylit_ref.views.shot import ArrayShot, Shot
    from stylit_ref.views.stylize_views import stylize_frames, stylize_views

__all__ = [
    "PRESETS",
    "REALTIME_PRESETS",
    "TEXTURE_PRESETS",
    "ArrayShot",
    "Coherence",
    "DraggedPatch",
    "Field",
    "FileShot",
    "FrameCancelledError",
    "FrameMotion",
    "FrameResult",
    "FrameStep",
    "GuideEncoding",
    "Guides",
    "InputError",
    "Iteration",
    "Motion",
    "Params",
    "PrincipalPacking",
    "Profile",
    "RealtimeField",
    "RealtimeParams",
    "RealtimeSession",
    "ReplayedFrame",
    "Result",
    "Run",
    "Shot",
    "StagePacking",
    "Step",
    "TextureField",
    "TextureParams",
    "TextureResult",
    "TextureSession",
    "ViewInterpolator",
    "choose_packing",
    "complete_texture",
    "drag",
    "drop",
    "grid_pairs",
    "make_tileable",
    "motion_between",
    "overlay",
    "pack",
    "paint",
    "read_any_field",
    "read_guides",
    "read_image",
    "read_motion",
    "read_nnf",
    "read_texture_field",
    "read_uint8",
    "replay",
    "replay_realtime",
    "replay_run",
    "replay_texture",
    "sequence_pairs",
    "stylize",
    "stylize_frames",
    "stylize_views",
    "synthesize_texture",
    "to_uint8",
    "views_of_run",
    "warm_up",
    "write_image",
    "write_nnf",
    "write_realtime_field",
    "write_texture_field",
]
__version__ = "0.1.0"

_HOMES = {
    "errors": ("InputError",),
    "files.colour.bit_depth": ("to_uint8",),
    "files.field": ("Field",),
    "files.guides.encoding": ("GuideEncoding",),
    "files.guides.read_guides": ("Guides", "read_guides"),
    "files.nnf_file": ("read_nnf", "write_nnf"),
    "files.read_image": ("read_image", "read_uint8"),
    "files.realtime_field": ("RealtimeField", "read_any_field", "write_realtime_field"),
    "files.texture_field": ("TextureField", "read_texture_field", "write_texture_field"),
    "files.write_image": ("write_image",),
    "machine.profiling": ("Profile",),
    "realtime.packing.choose": ("choose_packing",),
    "realtime.packing.packed": ("pack",),
    "realtime.packing.principal": ("PrincipalPacking",),
    "realtime.packing.stage": ("StagePacking",),
    "realtime.params": ("REALTIME_PRESETS", "RealtimeParams"),
    "realtime.replaying": ("replay_realtime",),
    "realtime.session": ("FrameCancelledError", "RealtimeSession"),
    "stylization.params": ("PRESETS", "Params"),
    "stylization.progress": ("Step",),
    "stylization.replaying": ("replay",),
    "stylization.stylize": ("Result", "stylize"),
    "stylization.warm_up": ("warm_up",),
    "texture.complete": ("complete_texture", "make_tileable"),
    "texture.dragging": ("DraggedPatch", "drag", "drop"),
    "texture.iteration": ("Iteration",),
    "texture.overlay": ("overlay",),
    "texture.painting": ("paint",),
    "texture.params": ("TEXTURE_PRESETS", "TextureParams"),
    "texture.replaying": ("replay_texture",),
    "texture.session": ("TextureSession",),
    "texture.synthesize": ("TextureResult", "synthesize_texture"),
    "views.file_shot": ("FileShot",),
    "views.frames": ("Motion", "grid_pairs", "sequence_pairs"),
    "views.interpolation.of_run": ("views_of_run",),
    "views.interpolation.view_interpolator": ("ViewInterpolator",),
    "views.motion.between": ("motion_between",),
    "views.motion.conventions": ("FrameMotion",),
    "views.motion.reading": ("read_motion",),
    "views.params": ("Coherence",),
    "views.shot": ("ArrayShot", "Shot"),
    "views.frame_result": ("FrameResult",),
    "views.replaying": ("ReplayedFrame", "replay_run"),
    "views.run_folder": ("Run",),
    "views.stylize_views": ("stylize_frames", "stylize_views"),
    "views.frame_step": ("FrameStep",),
}


def __getattr__(name: str) -> Any:
    """Import a public name when it is first used.

    Synthesis then needs no OpenImageIO, and the oracle's checker no Numba. The imports above tell
    type checkers the same names (``tests/test_api.py`` compares the two lists).
    """
    for home, names in _HOMES.items():
        if name in names:
            return getattr(import_module(f"stylit_ref.{home}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
