"""Names of Blender's passes: short ones up to version 4, long ones from 5 on."""

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
_OTHER = {short.casefold(): long for short, long in _LONG.items()}
_OTHER |= {long.casefold(): short for short, long in _LONG.items()}


def other_name(name: str) -> str | None:
    """What another version of Blender calls a pass, with the same view layer before it, if any.

    ``ViewLayer.DiffDir`` is ``ViewLayer.Diffuse Direct``, and the other way round.
    """
    view_layer, dot, own = name.rpartition(".")
    other = _OTHER.get(own.casefold())
    return other and f"{view_layer}{dot}{other}"
