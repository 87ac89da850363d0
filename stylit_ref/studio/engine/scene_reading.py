"""A scene from image files, read as ``run`` reads them."""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.guides.encoding import GuideEncoding
from stylit_ref.files.guides.read_guides import with_channels
from stylit_ref.files.guides.remarks import GuideRemarks
from stylit_ref.files.guides.survey import GuideLook, look_at, read_source_guide
from stylit_ref.files.picture import read_picture
from stylit_ref.realtime.packing.named_buffers import name_of_file, roles_of
from stylit_ref.studio.engine.scene import Buffers, Scene, SceneFiles


def read_scene(
    name: str, title: str, guides: Sequence[Sequence[str]], layers: Sequence[str] = ()
) -> Scene:
    """Read the source of a scene; the steps of its target are read when they are looked at.

    Parameters
    ----------
    name, title : str
    guides : sequence of sequence of str
        For each guide the file of the source, then that of each step; a layer may follow a colon.
    layers : sequence of str
        Layers to pick from.

    Returns
    -------
    Scene

    Raises
    ------
    InputError
        If a file cannot be read, or files do not go together.
    """
    if not guides or len({len(paths) for paths in guides}) != 1 or len(guides[0]) < 2:
        raise InputError(f"{name}: each guide needs a file of the source and one of every step")
    remarks, source, encodings = GuideRemarks(), [], []
    for paths in guides:
        looks = [look_at(path, needs_values=True) for path in paths]
        _check_alike(paths, looks)
        guide, encoding = read_source_guide(paths[0], paths[1], looks, "auto", remarks)
        source.append(guide)
        encodings.append(encoding)
    remarks.note()
    roles = roles_of([name_of_file(paths[0]) for paths in guides], encodings)
    own, *steps = zip(*guides, strict=True)
    channels = [guide.shape[2] for guide in source]
    return Scene(
        name,
        title,
        dict(zip(roles, source, strict=True)),
        [_reader(roles, files, encodings, channels) for files in steps],
        SceneFiles(own, tuple(steps)),
        tuple(encodings),
        tuple(layers),
    )


def _check_alike(paths: Sequence[str], looks: Sequence[GuideLook]) -> None:
    """Steps must have the same channels: a step is to be read as ``run`` reads it alone."""
    kinds = {(look.colours, look.has_alpha) for look in looks[1:]}
    if len(kinds) > 1:
        raise InputError(
            f"{paths[1]}: has other channels than another step; save all steps with the same"
        )


def _reader(
    roles: Sequence[str],
    files: Sequence[str],
    encodings: Sequence[GuideEncoding],
    channels: Sequence[int],
) -> Callable[[], Buffers]:
    def read() -> dict[str, NDArray[np.uint8]]:
        guides = map(_read_guide, files, encodings, channels)
        return dict(zip(roles, guides, strict=True))

    return read


def _read_guide(file: str, encoding: GuideEncoding, channels: int) -> NDArray[np.uint8]:
    picture = read_picture(file, is_guide=True)
    wants_alpha = channels in (2, 4)
    return with_channels(
        encoding.encode(picture),
        has_alpha=picture.alpha_channel is not None,
        colours=channels - wants_alpha,
        wants_alpha=wants_alpha,
    )
