"""Names of Blender's passes: short ones up to version 4, long ones from 5 on."""

import re


def _letters(name):
    """A name without what it may be spelled with or without."""
    return re.sub("[ _-]", "", name).casefold()


_LONG = {
    "AO": "Ambient Occlusion",
    "DiffCol": "Diffuse Color",
    "DiffDir": "Diffuse Direct",
    "DiffInd": "Diffuse Indirect",
    "Emit": "Emission",
    "Env": "Environment",
    "GlossCol": "Glossy Color",
    "GlossDir": "Glossy Direct",
    "GlossInd": "Glossy Indirect",
    "IndexMA": "Material Index",
    "IndexOB": "Object Index",
    "SubsurfaceCol": "Subsurface Color",
    "SubsurfaceDir": "Subsurface Direct",
    "SubsurfaceInd": "Subsurface Indirect",
    "TransCol": "Transmission Color",
    "TransDir": "Transmission Direct",
    "TransInd": "Transmission Indirect",
    "Transp": "Transparent",
    "VolumeDir": "Volume Direct",
    "VolumeInd": "Volume Indirect",
    "Z": "Depth",
}
_SPELLED = {_letters(spelled): names for names in _LONG.items() for spelled in names}


def names_of_pass(name: str) -> tuple[str, ...]:
    """What the versions of Blender call a pass, with the same view layer before it, if any.

    ``ViewLayer.object_index`` is ``ViewLayer.IndexOB`` and ``ViewLayer.Object Index``. What is no
    pass of Blender has no such names.
    """
    view_layer, dot, own = name.rpartition(".")
    return tuple(f"{view_layer}{dot}{each}" for each in _SPELLED.get(_letters(own), ()))
