"""The data set's views and motion fields, by the names of its pieces."""

import mitsuba as mi
import mitsuba_oidn as oidn
import numpy as np

from data_gen.camera import GRID, HOUSE_SOURCE, STAGE_VIEW
from data_gen.features import features, trace
from data_gen.light_paths import LAYERS, LightPaths
from data_gen.models import TARGETS, sphere
from data_gen.motion import motion_field
from data_gen.stage import house_scene, load, on_stage

mi.register_integrator("light_paths", LightPaths)


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

    def view(self, piece):
        """All layers of ``source``, a target, ``house/source`` or ``house/ROW_COLUMN``.

        Returns
        -------
        dict of str to (H, W, n) float32
            Rounded to half floats; light passes are scene-linear.
        """
        scene, _, place = piece.partition("/")
        if scene == "house":
            views = {f"{row}_{column}": camera for (row, column), camera in GRID.items()}
            return self._layers(house_scene(), (views | {"source": HOUSE_SOURCE})[place])
        model = sphere() if piece == "source" else TARGETS[piece]()
        return self._layers(on_stage(model), STAGE_VIEW)

    def motion(self):
        """Motion fields between neighbours of the house's grid, both ways.

        Yields
        ------
        str, dict of str to (H, W, n) float32
            ``0_0_to_0_1`` and its layers.
        """
        scene = house_scene()
        loaded = self._load(scene, HOUSE_SOURCE)
        for (row, column), camera in GRID.items():
            surface = trace(loaded, scene, camera, self.height, self.width)
            for down, right in ((0, -1), (0, 1), (-1, 0), (1, 0)):
                other = row + down, column + right
                if other in GRID:
                    motion, visible = motion_field(loaded, surface, GRID[other])
                    name = "{}_{}_to_{}_{}".format(row, column, *other)
                    yield name, {"MOTION": motion, "VISIBLE": visible}

    def _load(self, scene, camera):
        integrator = {"type": "light_paths"}
        return load(scene, camera, self.height, self.width, self.samples, integrator)

    def _layers(self, scene, camera):
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


def _denoised(image, albedo, normal):
    """A light pass without the noise of its samples (Open Image Denoise)."""
    image, albedo, normal = (np.ascontiguousarray(layer) for layer in (image, albedo, normal))
    return np.maximum(
        oidn.denoise(image, albedo, normal, hdr=True, clean_aux=True, input_scale=1.0), 0
    )


def _half(layer):
    """Values as the file will hold them."""
    return layer.astype(np.float16).astype(np.float32)
