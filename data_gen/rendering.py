"""Layers of views and motion fields, rendered."""

from itertools import groupby, pairwise
from operator import itemgetter

import mitsuba as mi
import mitsuba_oidn as oidn
import numpy as np

from data_gen.features import features, trace
from data_gen.light_paths import LAYERS
from data_gen.load import load
from data_gen.motion import motion_field, turned_with
from data_gen.wireframe import visible_wires


class Rendering:
    """Renders at one size.

    Parameters
    ----------
    size : (int, int)
        Width, height.
    samples : int
        A pixel.
    seed : int
    """

    def __init__(self, size, samples, seed):
        (self.width, self.height), self.samples, self.seed = size, samples, seed

    def layers(self, scene, camera):
        """All layers of a view.

        Parameters
        ----------
        scene : Scene
        camera : Camera

        Returns
        -------
        dict of str to (H, W, n) float32
            Rounded to half floats; light passes are scene-linear.
        """
        rendered = self._load(scene, camera)
        image = np.array(mi.render(rendered, seed=self.seed))[..., 3:]
        light = {name: image[..., 3 * k : 3 * k + 3] for k, name in enumerate(LAYERS)}
        aux = light.pop("ALBEDO"), light.pop("NORMAL")
        for name in ("FULL", "LDDE"):  # direct light has little noise to remove
            light[name] = _denoised(light[name], *aux)
        light["LD12E"] = light["LDE"] + light["LDDE"]
        surface = trace(rendered, scene, camera, self.height, self.width)
        layers = light | features(rendered, scene, camera, surface, light["LSE"])
        return {name: _half(layer) for name, layer in layers.items()}

    def wires(self, scene, camera):
        """What a view shows of the edges of a scene.

        Parameters
        ----------
        scene : Scene
        camera : Camera

        Returns
        -------
        data_gen.wireframe.VisibleWires
        """
        return visible_wires(self._load(scene, camera), scene, camera, self.height, self.width)

    def motion(self, scene, cameras, pairs):
        """Motion fields between views.

        Parameters
        ----------
        scene : Scene
        cameras : dict of str to Camera
            Of each view.
        pairs : iterable of (str, str)
            From which view to which; those from one view lie together.

        Yields
        ------
        str, dict of str to (H, W, n) float32
            ``0_0_to_0_1`` and its layers.
        """
        any_camera = next(iter(cameras.values()))
        loaded = self._load(scene, any_camera)  # for its surfaces alone
        for view, its_pairs in groupby(pairs, key=itemgetter(0)):
            surface = trace(loaded, scene, cameras[view], self.height, self.width)
            for _, other in its_pairs:
                motion, visible = motion_field(loaded, surface, cameras[other])
                yield f"{view}_to_{other}", {"MOTION": motion, "VISIBLE": visible}

    def motion_of_turn(self, frames, degrees):
        """Motion fields between neighbouring frames of an object that turns, both ways.

        Parameters
        ----------
        frames : iterable of (Scene, Camera)
            The object is the first part of each scene.
        degrees : float
            By which the object turns from a frame to the next.

        Yields
        ------
        str, dict of str to (H, W, n) float32
            ``00_to_01`` and its layers.
        """
        for number, (before, after) in enumerate(pairwise(map(self._traced, frames))):
            for (_, _, seen), (loaded, camera, _), turn, name in (
                (before, after, degrees, f"{number:02}_to_{number + 1:02}"),
                (after, before, -degrees, f"{number + 1:02}_to_{number:02}"),
            ):
                motion, visible = motion_field(loaded, turned_with(seen, 0, turn), camera)
                yield name, {"MOTION": motion, "VISIBLE": visible}

    def _traced(self, frame):
        scene, camera = frame
        loaded = self._load(scene, camera)
        return loaded, camera, trace(loaded, scene, camera, self.height, self.width)

    def _load(self, scene, camera):
        integrator = {"type": "light_paths"}
        return load(scene, camera, self.height, self.width, self.samples, integrator)


def _denoised(image, albedo, normal):
    """A light pass without the noise of its samples (Open Image Denoise)."""
    image, albedo, normal = (np.ascontiguousarray(layer) for layer in (image, albedo, normal))
    return np.maximum(
        oidn.denoise(image, albedo, normal, hdr=True, clean_aux=True, input_scale=1.0), 0
    )


def _half(layer):
    """Values as the file will hold them."""
    return layer.astype(np.float16).astype(np.float32)
