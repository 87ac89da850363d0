"""Layers of views and motion fields, rendered."""

import mitsuba as mi
import mitsuba_oidn as oidn
import numpy as np

from data_gen.features import features, trace
from data_gen.light_paths import LAYERS
from data_gen.load import load
from data_gen.motion import motion_field, turned_with


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

    def motion(self, scene, grid):
        """Motion fields between neighbours of a grid of views, both ways.

        Parameters
        ----------
        scene : Scene
        grid : dict of (int, int) to Camera
            By row and column.

        Yields
        ------
        str, dict of str to (H, W, n) float32
            ``0_0_to_0_1`` and its layers.
        """
        any_camera = next(iter(grid.values()))
        loaded = self._load(scene, any_camera)  # for its surfaces alone
        for (row, column), camera in grid.items():
            surface = trace(loaded, scene, camera, self.height, self.width)
            for down, right in ((0, -1), (0, 1), (-1, 0), (1, 0)):
                other = row + down, column + right
                if other in grid:
                    motion, visible = motion_field(loaded, surface, grid[other])
                    name = "{}_{}_to_{}_{}".format(row, column, *other)
                    yield name, {"MOTION": motion, "VISIBLE": visible}

    def motion_of_turn(self, scenes, camera, degrees):
        """Motion fields between neighbouring frames of an object that turns, both ways.

        Parameters
        ----------
        scenes : iterable of Scene
            A frame each; the object is the first part.
        camera : Camera
        degrees : float
            By which the object turns from a frame to the next.

        Yields
        ------
        str, dict of str to (H, W, n) float32
            ``00_to_01`` and its layers.
        """
        frames = enumerate(scenes)
        last, loaded, surface = self._traced(next(frames), camera)
        for frame in frames:
            number, after, surface_after = self._traced(frame, camera)
            for name, target, seen, turn in (
                (f"{last:02}_to_{number:02}", after, surface, degrees),
                (f"{number:02}_to_{last:02}", loaded, surface_after, -degrees),
            ):
                motion, visible = motion_field(target, turned_with(seen, 0, turn), camera)
                yield name, {"MOTION": motion, "VISIBLE": visible}
            last, loaded, surface = number, after, surface_after

    def _traced(self, frame, camera):
        number, scene = frame
        loaded = self._load(scene, camera)
        return number, loaded, trace(loaded, scene, camera, self.height, self.width)

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
