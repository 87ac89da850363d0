"""Lit Sphere (Sloan et al. 2001): the painted sphere as a table from normals to colours."""

import time
from dataclasses import dataclass

import numpy as np

from eval.device import processor
from eval.methods.normal_table import looked_up, normal_table, objects
from eval.outcome import Outcome
from stylit_ref.machine.code_digest import code_digest

_CODE = code_digest(__file__, without=("gpu_cuda",))


@dataclass(frozen=True)
class LitSphere:
    """Every pixel of the object takes the colour of the sphere's pixel with its normal.

    It says nothing about what is around the object, which stays white.
    """

    name = "Lit Sphere"
    cost = 0.1

    @property
    def code(self):
        """Digest of this file and what it imports."""
        return _CODE

    @property
    def device(self):
        """Name of the processor."""
        return processor()

    def run(self, scene, seed, progress=None):
        """Colour an object; there is no seed to choose.

        Parameters
        ----------
        scene : Scene
            With the buffers NORMAL and IDMASK.
        seed : int
        progress : callable, optional
            Not called: there are no steps.

        Returns
        -------
        Outcome
            Its time is that of a frame, on the processor; ``stages`` has that of the source's table
            too.

        Raises
        ------
        InputError
            If the scene lacks the buffers.
        """
        source, target = objects(scene)
        start = time.process_time()
        table = normal_table(source)
        made = time.process_time()
        colours = scene.style.reshape(-1, scene.style.shape[2])
        image = np.full((*target.mask.shape, colours.shape[1]), 255, np.uint8)
        image[target.mask] = colours[looked_up(table, target.normals[target.mask])]
        seconds = time.process_time() - made
        return Outcome(image, seconds, stages={"table": made - start, "cpu": seconds})
