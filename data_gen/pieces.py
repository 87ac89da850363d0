"""The pieces that a data set is made of: each makes the files of its own folder.

A scene is a few pieces; what another kind of piece needs is a class beside these, with a ``name``
and a method ``make``. What imports the renderer is imported where it is needed, after
:func:`data_gen.renderer.start`.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache, partial

from skimage.io import imsave

from data_gen.camera import GRID, HOUSE_SOURCE, STAGE_VIEW, Camera
from data_gen.guides import HOUSE_LIMITS, STAGE_LIMITS, Limits, guide, to_uint8
from data_gen.models import TARGETS, sphere
from data_gen.models.mesh import turned
from data_gen.multilayer_exr import write_layers
from data_gen.stage import Scene, house_scene, on_stage


@dataclass(frozen=True)
class View:
    """What a camera sees of a scene: guides, and the layers that they are made from.

    Attributes
    ----------
    name : str
        Of the piece and of its folder.
    scene : callable
        Builds the scene.
    camera : Camera
    limits : Limits
    """

    name: str
    scene: Callable[[], Scene]
    camera: Camera
    limits: Limits

    def make(self, folder, rendering, exr):
        """Render and write.

        Parameters
        ----------
        folder : Path
        rendering : data_gen.rendering.Rendering
        exr : bool
            Keep the layers, not only the guides made from them.

        Returns
        -------
        dict of str to (H, W, n) float32
            The layers.
        """
        layers = rendering.layers(self.scene(), self.camera)
        if exr:
            write_layers(folder / "passes.exr", layers)
        for name, layer in layers.items():
            image = guide(name, layer, self.limits)
            imsave(folder / f"{name}.png", image.squeeze(), check_contrast=False)
        return layers


@dataclass(frozen=True)
class Paintings:
    """A view, and every style painted over it.

    Attributes
    ----------
    view : View
    """

    view: View

    @property
    def name(self):
        """The view's."""
        return self.view.name

    def make(self, folder, rendering, exr):
        """As :meth:`View.make`; the styles go to a folder of their own."""
        from data_gen.styles import STYLES, subject

        seen = subject(self.view.make(folder, rendering, exr))
        (folder / "styles").mkdir()
        for name, paint in STYLES.items():
            image = to_uint8(paint(seen))
            imsave(folder / "styles" / f"{name}.png", image, check_contrast=False)


@dataclass(frozen=True)
class Motion:
    """Motion fields between neighbours of a grid of views, both ways.

    Attributes
    ----------
    name : str
    scene : callable
        Builds the scene.
    grid : dict of (int, int) to Camera
        By row and column.
    """

    name: str
    scene: Callable[[], Scene]
    grid: dict[tuple[int, int], Camera]

    def make(self, folder, rendering, exr):
        """Render and write; nothing but layers, which are kept whatever ``exr`` says."""
        for name, layers in rendering.motion(self.scene(), self.grid):
            write_layers(folder / f"{name}.exr", layers)


@dataclass(frozen=True)
class MotionOfTurn:
    """Motion fields between neighbouring frames of an object that turns, both ways.

    Attributes
    ----------
    name : str
    scenes : tuple of callable
        Each builds the scene of a frame.
    degrees : float
        By which the object turns from a frame to the next.
    """

    name: str
    scenes: tuple[Callable[[], Scene], ...]
    degrees: float

    def make(self, folder, rendering, exr):
        """Render and write; nothing but layers, which are kept whatever ``exr`` says."""
        scenes = (scene() for scene in self.scenes)
        for name, layers in rendering.motion_of_turn(scenes, STAGE_VIEW, self.degrees):
            write_layers(folder / f"{name}.exr", layers)


def turning(name, model, frames, degrees=1.0):
    """The pieces of a model that turns on the stage: a view for each frame, and the motion.

    Parameters
    ----------
    name : str
        Of the scene.
    model : callable
        Builds the mesh of the first frame.
    frames : int
    degrees : float
        From a frame to the next; the front turns towards the right.

    Returns
    -------
    tuple of View and MotionOfTurn
    """
    still = cache(model)  # a sculpture takes longer to build than to turn
    scenes = tuple(partial(_turned_on_stage, still, degrees * frame) for frame in range(frames))
    views = (
        View(f"{name}/{frame:02}", scene, STAGE_VIEW, STAGE_LIMITS)
        for frame, scene in enumerate(scenes)
    )
    return *views, MotionOfTurn(f"{name}/motion", scenes, degrees)


def _turned_on_stage(model, degrees):
    return on_stage(turned(model(), degrees))


def _on_stage(name, model):
    return View(name, lambda: on_stage(model()), STAGE_VIEW, STAGE_LIMITS)


_house_view = partial(View, scene=house_scene, limits=HOUSE_LIMITS)

SOURCE = Paintings(_on_stage("source", sphere))
"""Belongs to every data set."""

_STILL = {name: (_on_stage(name, model),) for name, model in TARGETS.items()} | {
    "house": (
        _house_view("house/source", camera=HOUSE_SOURCE),
        *(
            _house_view(f"house/{row}_{column}", camera=camera)
            for (row, column), camera in GRID.items()
        ),
        Motion("house/motion", house_scene, GRID),
    )
}

SCENES = _STILL | {"turning": turning("turning", TARGETS["golem"], frames=60)}
"""The pieces of every scene, by its name."""

USUAL = tuple(_STILL)
"""The scenes that are rendered if none are named: ``turning`` takes longer than all others."""
