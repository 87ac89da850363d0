"""Read guides: those of the source and of all targets together, so that they agree."""

from collections.abc import Sequence
from pathlib import Path
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.guides.choose_encoding import choose_encoding, plain_encoding
from stylit_ref.files.guides.encoding import GuideEncoding
from stylit_ref.files.guides.remarks import GuideRemarks
from stylit_ref.files.picture import Picture, read_picture


class Guides(NamedTuple):
    """Guides as :func:`stylit_ref.stylize` takes them.

    Attributes
    ----------
    source : tuple of (H_A, W_A, c) uint8
        A guide each.
    targets : tuple of tuple of (H_B, W_B, c) uint8
        The same guides of each target. Channels differ from the source's if the files differ and
        none is grey.
    encodings : tuple of GuideEncoding
        How the values of each guide became 8 bits.
    """

    source: tuple[NDArray[np.uint8], ...]
    targets: tuple[tuple[NDArray[np.uint8], ...], ...]
    encodings: tuple[GuideEncoding, ...]


def read_guides(
    files: Sequence[Sequence[str | Path]],
    guide_encoding: Literal["auto", "none"] | Sequence[GuideEncoding] = "auto",
) -> Guides:
    """Read the guides of a run, so that source and targets are encoded alike.

    Alpha is dropped if it is opaque in all images of a guide and otherwise kept, or added, in all;
    a grey image beside one in colour is spread to three channels. Notes tell what an encoding does,
    and which guides can hardly guide.

    Parameters
    ----------
    files : sequence of sequence of str or Path
        For each guide the file of the source and then that of each target, with a layer as in
        :func:`stylit_ref.read_image`. A whole Cryptomatte, ``scene.exr:CryptoObject``, is a guide
        too.
    guide_encoding : {"auto", "none"} or sequence of GuideEncoding
        ``"auto"`` chooses an encoding for each guide from all of its images; integers keep their
        values (:func:`~stylit_ref.files.guides.choose_encoding.choose_encoding`). ``"none"`` clips
        what lies outside [0, 1]. Encodings of an earlier call keep further frames alike.

    Returns
    -------
    Guides

    Raises
    ------
    InputError
        As :func:`stylit_ref.read_image` does; or if the guides have different numbers of targets,
        or the encodings are not one for each guide.
    """
    _check(files, guide_encoding)
    guides, encodings, remarks = [], [], GuideRemarks()
    for number, paths in enumerate(files):
        pictures = [read_picture(path, is_guide=True) for path in paths]
        if guide_encoding == "auto":
            encoding = choose_encoding(pictures)
        elif guide_encoding == "none":
            encoding = plain_encoding(pictures)
        else:
            encoding = guide_encoding[number]
        encoded = [encoding.encode(picture) for picture in pictures]
        remarks.add(paths, pictures, encoded, encoding)
        guides.append(_with_equal_channels(pictures, encoded))
        encodings.append(encoding)
    remarks.note()
    source, *targets = zip(*guides, strict=True)
    return Guides(source, tuple(targets), tuple(encodings))


def _check(files, guide_encoding):
    if isinstance(files, str | Path) or any(isinstance(paths, str | Path) for paths in files):
        raise InputError(
            "must hold, for each guide, the file of the source and those of the targets",
            parameter="files",
        )
    counts = {len(paths) for paths in files}
    if len(counts) != 1 or min(counts) < 2:
        raise InputError(
            f"holds guides of {', '.join(map(str, sorted(counts))) or 'no'} files; each needs one "
            "of the source and the same number of targets",
            parameter="files",
        )
    if isinstance(guide_encoding, str):
        if guide_encoding not in ("auto", "none"):
            raise InputError(
                f"is {guide_encoding!r}; it must be 'auto', 'none', or encodings",
                parameter="guide_encoding",
            )
    elif len(guide_encoding) != len(files):
        raise InputError(
            f"holds {len(guide_encoding)} encodings for {len(files)} guides; each guide needs one",
            parameter="guide_encoding",
        )


def _with_equal_channels(
    pictures: Sequence[Picture], encoded: Sequence[NDArray[np.uint8]]
) -> list[NDArray[np.uint8]]:
    has_alpha = [picture.alpha_channel is not None for picture in pictures]
    colours = max(guide.shape[2] - alpha for guide, alpha in zip(encoded, has_alpha, strict=True))
    return [
        with_channels(guide, has_alpha=alpha, colours=colours, wants_alpha=any(has_alpha))
        for guide, alpha in zip(encoded, has_alpha, strict=True)
    ]


def with_channels(
    guide: NDArray[np.uint8], *, has_alpha: bool, colours: int, wants_alpha: bool
) -> NDArray[np.uint8]:
    """A guide with the channels of others: grey is spread to colours, and opaque alpha added.

    Parameters
    ----------
    guide : (H, W, n) uint8
    has_alpha : bool
        Whether its last channel is alpha.
    colours : int
        Channels without alpha that the others have.
    wants_alpha : bool
        Whether one of them has alpha.

    Returns
    -------
    (H, W, m) uint8
        With other colours if it has neither one nor ``colours``.
    """
    if guide.shape[2] - has_alpha == 1:
        guide = np.concatenate([guide[:, :, :1]] * colours + [guide[:, :, 1:]], axis=2)
    if wants_alpha and not has_alpha:
        opaque = np.full((*guide.shape[:2], 1), 255, np.uint8)
        guide = np.concatenate([guide, opaque], axis=2)
    return guide
