"""Look at files of motion before any is used: what their headers tell."""

from collections.abc import Callable, Iterable, Iterator
from typing import Any

from stylit_ref.cli.motion_files import (
    NO_IDS,
    TWO_WAYS,
    MotionFiles,
    VectorsOfPairs,
    no_depth,
)
from stylit_ref.cli.shot_problems import ShotProblems
from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import split_layer
from stylit_ref.files.layers.channels import are_labels, words_of
from stylit_ref.files.layers.contents import contents_of
from stylit_ref.files.layers.layer import Layer
from stylit_ref.files.layers.names import SeveralLayersError
from stylit_ref.files.motion_file import look_at_vectors
from stylit_ref.files.picture import plain_layer
from stylit_ref.notes import note
from stylit_ref.stylization.checks import size_text
from stylit_ref.views.motion.conventions import AUTO, convention_named, convention_of

Size = tuple[int, int]

_STILL = (
    "has no vectors but 0 between the first two frames; if something moves there, switch Motion "
    "Blur off and render again ('stylit-ref motion check' tells more)"
)

_WHOLE_NUMBERS = {"uint8", "uint16"}


def check_motion_files(
    motion: Iterable[MotionFiles], size: Size | None, problems: ShotProblems
) -> None:
    """Find what keeps motion from being used, before it is.

    Of all files the header is read; if they are as they should be, the first pair is read whole.

    Parameters
    ----------
    motion : iterable of MotionFiles
    size : tuple of 2 int, or None
        Rows and columns of the frames; None where nobody knows.
    problems : ShotProblems
        What is found is added to it.
    """
    motion, is_usable = list(motion), True
    for look, path, *how in dict.fromkeys(each for files in motion for each in _looks_at(files)):
        try:
            found = look(path, *how)
        except InputError as error:
            problems.add(error.sentence, path)
            is_usable = False
            continue
        if size and found != size:
            problems.add(
                f"{path}: is {size_text(found)} but the frames are {size_text(size)}; all must "
                "have the same size",
                path,
            )
            is_usable = False
    if motion and is_usable:
        try:
            if not motion[0].read().field.any():
                note(_STILL, parameter="motion")
        except InputError as error:
            problems.add(error.sentence)


def _looks_at(
    motion: MotionFiles,
) -> Iterator[tuple[Any, ...]]:
    vectors, depth, ids = motion.kinds
    for path in vectors:
        yield _look_at_vectors, path, motion.convention, isinstance(motion, VectorsOfPairs)
    for path in depth:
        yield _look_at_depth, path
    for path in ids:
        yield _look_at_ids, path


def _look_at_vectors(path: str, convention: str, is_of_pair: bool) -> Size:
    look = look_at_vectors(path)
    if convention == AUTO:
        convention_of(look, path)
    else:
        wanted, found = 2 * len(convention_named(convention).leads), 2 * len(look.pairs)
        if wanted != found:
            raise InputError(
                f"{path}: has vectors of {found} channels, and the convention {convention} is for "
                f"{wanted}; auto takes what the names of the channels say"
            )
    if is_of_pair and look.pairs == (True, True):
        raise InputError(TWO_WAYS.format(path))
    return look.size


def _look_at_depth(path: str) -> Size:
    layer = _layer_of(path, lambda words: not words.isdisjoint(("depth", "z")))
    if layer is None:
        return _size_of(path)
    if len(layer.roles) > 1 or set(layer.types) <= _WHOLE_NUMBERS:
        raise InputError(no_depth(path, len(layer.roles), layer.types[0]))
    return layer.size


def _look_at_ids(path: str) -> Size:
    layer = _layer_of(path, are_labels)
    if layer is None:
        return _size_of(path)
    if len(layer.roles) > 1 and not set(layer.types) <= _WHOLE_NUMBERS:
        raise InputError(NO_IDS.format(path))
    return layer.size


def _layer_of(path: str, is_meant: Callable[[set[str]], bool]) -> Layer | None:
    """The layer of a path; of several one is offered whose name says that it is meant."""
    try:
        return plain_layer(path)
    except SeveralLayersError as error:
        meant = [name for name in error.names if is_meant(words_of(name))]
        best = meant[0] if meant else error.best
        raise SeveralLayersError(error.file, best, error.names) from None


def _size_of(path):
    """Of a file whose header does not tell what its layer is."""
    return contents_of(split_layer(path)[0]).layers[0].size
