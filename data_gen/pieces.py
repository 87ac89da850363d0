"""The kinds of pieces that a data set is made of: each makes the files of its own folder.

A scene is a few pieces (:mod:`data_gen.scenes`). What another kind of piece needs is a class beside
these, with a ``name`` and a method ``make``. What imports the renderer is imported where it is
needed, after :func:`data_gen.renderer.start`.
"""

import json
from collections.abc import Callable
from dataclasses import dataclass

from skimage.io import imsave

from data_gen.camera import Camera
from data_gen.guides import Limits, guide, to_uint8
from data_gen.models.mesh import to_obj
from data_gen.multilayer_exr import write_layers
from data_gen.stage import Scene


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
class Sketches:
    """A view of a building, and every architectural sketch drawn over it.

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
        """As :meth:`View.make`; the sketches go to a folder of their own."""
        from data_gen.sketches import SKETCHES, building

        layers = self.view.make(folder, rendering, exr)
        wires = rendering.wires(self.view.scene(), self.view.camera)
        seen = building(layers, wires.runs())
        (folder / "sketches").mkdir()
        for name, draw in SKETCHES.items():
            image = to_uint8(draw(seen))
            imsave(folder / "sketches" / f"{name}.png", image, check_contrast=False)


@dataclass(frozen=True)
class Motion:
    """Motion fields between views of a scene.

    Attributes
    ----------
    name : str
    scene : callable
        Builds the scene.
    cameras : dict of str to Camera
        Of each view.
    pairs : tuple of (str, str)
        From which view to which.
    """

    name: str
    scene: Callable[[], Scene]
    cameras: dict[str, Camera]
    pairs: tuple[tuple[str, str], ...]

    def make(self, folder, rendering, exr):
        """Render and write; nothing but layers, which are kept whatever ``exr`` says."""
        for name, layers in rendering.motion(self.scene(), self.cameras, self.pairs):
            write_layers(folder / f"{name}.exr", layers)


@dataclass(frozen=True)
class MotionOfTurn:
    """Motion fields between neighbouring frames of an object that turns, both ways.

    Attributes
    ----------
    name : str
    scenes : tuple of callable
        Each builds the scene of a frame.
    cameras : tuple of Camera
        Of each frame.
    degrees : float
        By which the object turns from a frame to the next.
    """

    name: str
    scenes: tuple[Callable[[], Scene], ...]
    cameras: tuple[Camera, ...]
    degrees: float

    def make(self, folder, rendering, exr):
        """Render and write; nothing but layers, which are kept whatever ``exr`` says."""
        frames = (
            (scene(), camera) for scene, camera in zip(self.scenes, self.cameras, strict=True)
        )
        for name, layers in rendering.motion_of_turn(frames, self.degrees):
            write_layers(folder / f"{name}.exr", layers)


@dataclass(frozen=True)
class SceneMesh:
    """``scene.obj``, the surface of a scene, for views between those that are rendered.

    Attributes
    ----------
    name : str
    scene : callable
        Builds the scene.
    """

    name: str
    scene: Callable[[], Scene]

    def make(self, folder, rendering, exr):
        """Write; nothing is rendered."""
        (folder / "scene.obj").write_text(to_obj(self.scene().parts))


@dataclass(frozen=True)
class ViewsManifest:
    """``views.json``, which tells ``stylit-ref views`` the files of a scene.

    Attributes
    ----------
    scene : str
    style : str
        File of the painting in the data set; its guides lie in the piece of its first folder.
    guides : tuple of str
    cameras : dict of str to Camera
        Of each view, by its name in the scene.
    rows : tuple of tuple of str
        Views that are neighbours, in rows and columns; a sequence is one row.
    has_motion : bool
    mesh : str or None
        Name of the piece that holds it.
    """

    scene: str
    style: str
    guides: tuple[str, ...]
    cameras: dict[str, Camera]
    rows: tuple[tuple[str, ...], ...]
    has_motion: bool = True
    mesh: str | None = None

    @property
    def name(self):
        """Of the piece and of its folder, which lies beside those of the scenes."""
        return f"manifests/{self.scene}"

    def make(self, folder, rendering, exr):
        """Write; nothing is rendered."""
        data, scene = "../../", f"../../{self.scene}"
        source = self.style.partition("/")[0]
        content = {
            "style": f"{data}{self.style}",
            "guides": [
                {
                    "source": f"{data}{source}/{guide}.png",
                    "view": f"{scene}/{{view}}/{guide}.png",
                }
                for guide in self.guides
            ],
            "grid": self.rows,
            "cameras": {view: camera._asdict() for view, camera in self.cameras.items()},
        }
        if self.has_motion:
            content["motion"] = f"{scene}/motion/{{view}}_to_{{other}}.exr"
            content["motion_convention"] = "own"
            content["ids"] = f"{scene}/{{view}}/IDMASK.png"
            if exr:  # DEPTH.png is larger where it is nearer
                content["depth"] = f"{scene}/{{view}}/passes.exr:DEPTH"
        if self.mesh:
            content["mesh"] = f"{data}{self.mesh}/scene.obj"
        (folder / "views.json").write_text(json.dumps(content, indent=1) + "\n")
