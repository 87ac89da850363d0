"""A sketch beside copies of itself that are turned, and a guide that chooses between them.

Patches of a painting keep their angle. Turned copies beside it are more of the same painting, so
that no search has to know of angles: a guide tells in which direction the surface lies.
"""

from dataclasses import dataclass, replace

import numpy as np
import pandas as pd
from skimage.transform import rotate

from eval.methods.stylit_ref import StylitRef
from eval.metrics.off_surface import DIRECTION
from stylit_ref.machine.code_digest import code_digest

_CODE = code_digest(__file__, without=("gpu_cuda",))

_LEVEL = 0.99
"""The least upward part of a normal whose face has no line of steepest descent."""


def projected_direction(normals, camera):
    """The direction in which faces are seen to descend; of level ones, that of the x axis.

    Angles are doubled, since a line has no front, and told by cosine and sine, since they turn.

    Parameters
    ----------
    normals : (H, W, 3) uint8
        The pass NORMAL; of length 0 where nothing is seen.
    camera : data_gen.camera.Camera

    Returns
    -------
    (H, W, 2) uint8
        Cosine and sine of twice the angle, x right, y down; their middle, 128, where nothing is.
    """
    normal = normals / 127.5 - 1
    is_level = np.abs(normal[..., 1:2]) > _LEVEL
    descent = np.where(is_level, (1.0, 0.0, 0.0), (0.0, 1.0, 0.0) - normal * normal[..., 1:2])
    axes = camera.axes().T
    ray, line = camera.directions(*normals.shape[:2]) @ axes, descent @ axes
    # The derivative of where a point is seen, as it moves along the line, times a square.
    across, up = (line[..., k] * ray[..., 2] - ray[..., k] * line[..., 2] for k in (0, 1))
    double = (across - 1j * up) ** 2
    is_seen = np.linalg.norm(normal, axis=-1) > 0.5
    return _encoded(np.where(is_seen, double / np.maximum(np.abs(double), 1e-12), 0))


def with_turned_copies(scene, angles):
    """A scene whose source is turned copies of its source, with the direction as its last guide.

    Guides of light, shadows and edges show the same after a turn; the direction turns with the
    picture. Beyond a copy's own corners the picture is mirrored, and there is no direction.

    Parameters
    ----------
    scene : eval.scenes.Scene
        With the buffer DIRECTION.
    angles : sequence of float
        Degrees, clockwise.

    Returns
    -------
    eval.scenes.Scene
    """
    source, target = scene.buffers[DIRECTION]
    guides = [
        np.hstack([_turned(guide, angle) for angle in angles]) for guide in scene.source_guides
    ]
    directions = np.hstack([_turned_direction(source, angle) for angle in angles])
    return replace(
        scene,
        guide_names=(*scene.guide_names, DIRECTION),
        style=np.hstack([_turned(scene.style, angle) for angle in angles]),
        source_guides=(*guides, directions),
        target_guides=(*scene.target_guides, target),
    )


def turned_back(nnf, angles, size):
    """Where the places of turned copies come from in the picture itself.

    Parameters
    ----------
    nnf : (H, W, 2) int32
        Places ``(y, x)`` in copies side by side.
    angles : sequence of float
    size : (int, int)
        Rows and columns of the picture.

    Returns
    -------
    (H, W, 2) int32
        The nearest place in the picture.
    """
    copy, column = np.divmod(nnf[..., 1], size[1])
    middle = (size[0] - 1) / 2 + 1j * (size[1] - 1) / 2
    # Row plus i times column: a turn clockwise goes from columns to rows.
    place = middle + (nnf[..., 0] + 1j * column - middle) * np.exp(
        1j * np.radians(np.asarray(angles, float))[copy]
    )
    nearest = np.round(np.stack([place.real, place.imag], axis=-1)).astype(np.int32)
    return np.clip(nearest, 0, np.array(size, np.int32) - 1)


@dataclass(frozen=True)
class Turned(StylitRef):
    """Stylization from turned copies; the history tells the share of each copy.

    Attributes
    ----------
    angles : tuple of float
        Of the copies, in degrees.
    weight : float
        Of a channel of the direction over one of another guide, which weigh as they do without it.
    """

    angles: tuple[float, ...] = (0.0,)
    weight: float = 1.0

    @property
    def name(self):
        """The method, its copies, and the weight of the direction."""
        return f"{super().name}, {len(self.angles)} copies, direction {self.weight:g}"

    @property
    def code(self):
        """Digest of the algorithms, and of what is done here."""
        return _CODE

    def run(self, scene, seed, progress=None):
        """As :meth:`eval.methods.stylit_ref.StylitRef.run`; the NNF leads into the sketch itself.

        λ counts how often a pixel is used beside the mean of all: copies are no reason to use each
        of them, and λ is divided by their number.
        """
        channels = sum(guide.shape[2] for guide in scene.source_guides)
        params = replace(
            self.params,
            guide_influence=self.params.guide_influence * (channels + 2) / channels,
            guide_weights=(*len(scene.source_guides) * (1.0,), self.weight),
            uniformity=self.params.uniformity / len(self.angles),
        )
        copies = with_turned_copies(scene, self.angles)
        found = StylitRef(params).run(copies, seed, progress)
        height, width = scene.style.shape[:2]
        uses = np.bincount(found.nnf[..., 1].ravel() // width, minlength=len(self.angles))
        return replace(
            found,
            nnf=turned_back(found.nnf, self.angles, (height, width)),
            history=pd.DataFrame({"angle": self.angles, "share": uses / uses.sum()}),
            omega=None,
        )


def _turned(image, angle):
    """An image turned clockwise about its middle; mirrored beyond its corners."""
    if not angle:
        return image
    # A spline of degree 3 would take a third of the energy of fine strokes, this one a sixth.
    return np.uint8(np.round(rotate(image.astype(float), -angle, order=5, mode="symmetric")))


def _turned_direction(direction, angle):
    """The same of a direction, which turns itself; none beyond the corners."""
    double = (direction / 127.5 - 1) @ (1, 1j)
    parts = [
        rotate(part, -angle, order=1, mode="constant", cval=0)
        for part in (double.real, double.imag)
    ]
    return _encoded((parts[0] + 1j * parts[1]) * np.exp(2j * np.radians(angle)))


def _encoded(double):
    """A complex number on 8 bits, (H, W, 2)."""
    parts = np.stack([double.real, double.imag], axis=-1)
    return np.uint8(np.clip(np.floor(127.5 * (parts + 1) + 0.5), 0, 255))
