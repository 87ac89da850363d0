"""Put the arrays of a case into a level of the library."""

import numpy as np

from stylit_ref import Params
from stylit_ref.machine.vector_ssd import LANES
from stylit_ref.metric.packing import Packing
from stylit_ref.stylization.exemplar import Exemplar
from stylit_ref.stylization.level import Level
from stylit_ref.stylization.target import Target


def level_of_case(passes, parameters, arrays):
    """Make a level of the library from the arrays of a case.

    Parameters
    ----------
    passes : module
    parameters : dict
        ``patch_width``, ``guide_channels``; ``epsilon`` for a level with a guide map.
    arrays : dict of str to array
        ``source``, ``target``, ``weights``, and possibly ``nnf``, ``delta``, ``omega_sums``.

    Returns
    -------
    Level
    """
    guides = parameters["guide_channels"]
    packing = _packing(arrays["weights"], guides)
    params = Params(patch_width=parameters["patch_width"])
    if "epsilon" in parameters:
        params = Params(
            "guide_map", patch_width=parameters["patch_width"], epsilon=parameters["epsilon"]
        )
    textures = []
    for name in ("source", "target"):
        channels = np.split(arrays[name], range(1, guides + 1), axis=2)
        textures.append(packing.pack(channels[:-1], channels[-1]))
    size = arrays["target"].shape[:2]
    synthesized = arrays["nnf"][:, :, 0] >= 0 if "nnf" in arrays else np.ones(size, bool)
    source, target = textures
    level = Level(
        Exemplar(passes, packing, params.patch_width, source).level(0),
        Target(passes, packing, params.patch_width, target, synthesized).level(0),
        params,
    )
    for name in ("nnf", "delta", "omega_sums"):
        if name in arrays:
            setattr(level, name, passes.upload(arrays[name].copy()))
    level.occurrence_weight = parameters.get("occurrence_weight", 0)
    return level


def _packing(weights, guides):
    """A packing whose channels have these weights."""
    places, packed = [], []
    for channel, weight in enumerate(weights.tolist()):
        if channel == guides and len(packed) % 2:
            packed.append(0)
        if len(packed) % 2 and packed[-1] != weight:
            packed.append(0)
        places.append(len(packed))
        packed.append(weight)
    packed += [0] * (-len(packed) % LANES)
    return Packing(
        guide_channels=tuple(places[:guides]),
        guide_sizes=(1,) * guides,
        style_channel=places[guides],
        style_channels=len(places) - guides,
        channels=len(packed),
        weights=np.array(packed, np.int64),
    )
