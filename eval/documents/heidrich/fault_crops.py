"""Where a picture shows a fault most: crops of it, and of others there."""

import numpy as np
from scipy.ndimage import distance_transform_edt
from skimage.morphology import skeletonize

from eval.documents.heidrich.places import densest
from eval.metrics.ground_seams import flat_ground, misfits
from eval.metrics.sharpness import detail
from eval.metrics.stroke_ends import ends_of, is_dark
from eval.metrics.wrong_things import BAND, FOREGROUND, views_of


def crops_of(number, scene, run, images):
    """A row of crops.

    Parameters
    ----------
    number : str
        One of ``ground_seams``, ``grid_contrast``, ``ragged``, ``stroke_ends``.
    scene : Scene
    run : Run
        The picture that shows the fault.
    images : dict of str to (H, W, n) uint8
        Pictures by their titles.

    Returns
    -------
    list of (str, array)
    """
    window = densest(_WHERE[number](scene, run))
    return [(name, image[window]) for name, image in images.items()]


def _seams(scene, run):
    ground = flat_ground(views_of(scene)[1].labels)
    found = np.zeros(ground.shape)
    found[ground] = misfits(run.image, scene.style, run.nnf, ground)
    return found


def _grain(scene, run):
    return detail(run.image) * flat_ground(views_of(scene)[1].labels)


def _silhouettes(scene, run):
    inside = views_of(scene)[1].labels == FOREGROUND
    return np.maximum(distance_transform_edt(inside), distance_transform_edt(~inside)) <= BAND


def _ends(scene, run):
    return ends_of(skeletonize(is_dark(run.image, scene.style)))


_WHERE = {
    "ground_seams": _seams,
    "grid_contrast": _grain,
    "ragged": _silhouettes,
    "stroke_ends": _ends,
}
