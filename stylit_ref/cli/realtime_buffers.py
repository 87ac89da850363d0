"""Guides of ``run`` for ``--method realtime``: what their files are called, and ``--weight``."""

import argparse
from collections.abc import Sequence

from stylit_ref.cli.guide_options import guide_weights
from stylit_ref.cli.images_in import ImagesIn
from stylit_ref.errors import InputError
from stylit_ref.realtime.packing import Packing, PrincipalPacking
from stylit_ref.realtime.packing.named_buffers import (
    NamedBuffers,
    name_of_file,
    named_buffers,
    roles_of,
    weights_of_channels,
)


def buffers_of_files(files: Sequence[tuple[str, str]], images: ImagesIn) -> NamedBuffers:
    """Name the guides: by layer or file, as ``FULL`` of ``scene.exr:FULL`` or ``scene_full.png``.

    Parameters
    ----------
    files : sequence of (str, str)
        Source and target of each guide.
    images : ImagesIn
    """
    names = [name_of_file(source) for source, _ in files]
    roles = roles_of(names, images.guide_encodings)
    return named_buffers(roles, images.source_guides, images.target_guides)


def weights_of(
    options: argparse.Namespace, packing: Packing, buffers: NamedBuffers
) -> tuple[int, ...] | None:
    """The weight of each byte of a pixel, None where no ``--weight`` is given.

    Raises
    ------
    InputError
        If one is no whole number, or the packing mixes the guides.
    """
    if not options.guide_weights:
        return None
    if isinstance(packing, PrincipalPacking):
        raise InputError(
            "cannot be given with --packing pca, whose components mix the guides; leave it out",
            parameter="guide_weights",
        )
    weights = guide_weights(options)
    if not all(weight.is_integer() and weight >= 0 for weight in weights):
        raise InputError(
            "must be a whole number from 0 with --method realtime; 0 leaves a guide out",
            parameter="guide_weights",
        )
    return weights_of_channels(list(map(int, weights)), packing, buffers.guide_of)
