"""``file:LAYER`` names a layer of a file, or a channel of it."""

import shlex
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Protocol, TypeVar

from stylit_ref.errors import InputError
from stylit_ref.files.layers.blender_names import names_of_pass
from stylit_ref.files.layers.contents import Contents
from stylit_ref.files.layers.layer import Layer

_BEAUTY = ("combined", "beauty", "rgba", "full", "color")


class SeveralLayersError(InputError):
    """A file has several layers, and nothing says which of them is meant.

    Parameters
    ----------
    file : Path
    best : str
        Name of the layer that is most likely meant.
    names : list of str
        All there are.
    other_way : str
        What one can do in place of writing the name of the best; a caller may know more than this
        module.
    """

    def __init__(self, file: Path, best: str, names: list[str], other_way: str = "") -> None:
        self.file: Path = file
        self.best: str = best
        self.names: list[str] = names
        super().__init__(
            f"{file}: has several layers; write {whole_name(file, best)}{other_way}; its layers "
            f"are: {', '.join(names)}"
        )


class Named(Protocol):
    """What has a name of its own, and others that it answers to."""

    @property
    def name(self) -> str:
        """Its own."""
        ...

    @property
    def also(self) -> tuple[str, ...]:
        """The others."""
        ...


AnyNamed = TypeVar("AnyNamed", bound=Named)


def fitting(typed: str, candidates: Sequence[AnyNamed]) -> list[AnyNamed]:
    """The layers that a name fits best, none if it fits none.

    A layer's own name fits best, then another name that it answers to, then one in other letters,
    then the end of its name, or of another: ``DiffDir`` fits ``ViewLayer.DiffDir``.
    """
    small = typed.casefold()
    ways: tuple[Callable[[AnyNamed], bool], ...] = (
        lambda layer: layer.name == typed,
        lambda layer: typed in layer.also,
        lambda layer: small in {name.casefold() for name in (layer.name, *layer.also)},
        lambda layer: layer.name.casefold().endswith(f".{small}"),
        lambda layer: any(name.casefold().endswith(f".{small}") for name in layer.also),
    )
    found = ([layer for layer in candidates if fits(layer)] for fits in ways)
    return next(filter(None, found), [])


def whole_name(file: str | Path, name: str) -> str:
    """What names a layer on the command line, in quotes where the shell needs them."""
    return shlex.quote(f"{file}:{name}" if name else str(file))


def find_layer(file: Path, name: str | None, contents: Contents) -> Layer:
    """Find a layer by its name, or a channel.

    Parameters
    ----------
    file : Path
    name : str or None
        None is the unnamed layer, or the only one.
    contents : Contents
        Of that file.

    Returns
    -------
    Layer

    Raises
    ------
    SeveralLayersError
        If no name is given, and none of several layers is the unnamed one.
    InputError
        If the file has no such layer, or several that the name fits.
    """
    if not name:
        return _unnamed(file, contents)
    channels = [channel for layer in contents.layers for channel in layer.channels]
    prefix, _, channel = name.rpartition(".")
    spelled = [(each, contents.layers) for each in (name, *names_of_pass(name))]
    spelled += [
        (name, channels),
        *((f"{each}.{channel}", channels) for each in names_of_pass(prefix)),
    ]
    found = next(filter(None, (fitting(*each) for each in spelled)), [])
    if len(found) == 1:
        return found[0]
    if found:
        several = ", ".join(whole_name(file, layer.name) for layer in found)
        raise InputError(f"{file}: '{name}' fits several layers; write one of these: {several}")
    known = ", ".join(layer.name for layer in contents.layers if layer.name) or "none"
    raise InputError(f"{file}: has no layer '{name}'; its layers are: {known}")


def _unnamed(file, contents):
    layers = contents.layers
    unnamed = next((layer for layer in layers if not layer.name), None)
    if len(layers) == 1 or (unnamed and unnamed.is_light):
        return unnamed or layers[0]
    named = [layer for layer in layers if layer.name]
    shown = min(named, key=lambda layer: (not layer.is_light, _beauty(layer)))
    raise SeveralLayersError(file, shown.name, [layer.name for layer in named])


def _beauty(layer):
    """Where it stands among the names of the picture that shows everything."""
    last = layer.name.rpartition(".")[2].casefold()
    return _BEAUTY.index(last) if last in _BEAUTY else len(_BEAUTY)
