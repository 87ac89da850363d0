"""A layer of an image file: of an EXR what the names of its channels or its parts tell."""

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, replace

import OpenImageIO as oiio

from stylit_ref.files.layers.channels import are_labels, choose, is_data, split_names, words_of


@dataclass(frozen=True)
class Layer:
    """Channels that belong together.

    Attributes
    ----------
    name : str
        What one writes after the colon; ``""`` where one writes nothing.
    part : int
        Number of the file's part that has them.
    numbers : tuple of int
        Numbers of the channels within their part, in the order in which they are read.
    roles : tuple of str
        What each of them is for, as of :func:`stylit_ref.files.layers.channels.split_names`.
    is_light : bool
        Whether they are colours or luminance; otherwise they are data.
    types : tuple of str
        The type of the values of each of them, as OpenImageIO calls it.
    is_deep : bool
        Whether a pixel has any number of values, at several depths.
    file_format : str
        Of its file, as OpenImageIO calls it.
    size : tuple of 2 int
        Rows and columns of its picture, upright.
    also : tuple of str
        Other names of the layer: of its part, and of its view.
    channels : tuple of Layer
        All channels that have its name before theirs, each as a layer of its own.
    """

    name: str
    part: int
    numbers: tuple[int, ...]
    roles: tuple[str, ...]
    is_light: bool
    types: tuple[str, ...]
    is_deep: bool
    file_format: str
    size: tuple[int, int]
    also: tuple[str, ...]
    channels: tuple["Layer", ...] = ()

    @property
    def alpha_channel(self) -> int | None:
        """Index of the alpha channel; what is alone is data."""
        return len(self.roles) - 1 if len(self.roles) > 1 and self.roles[-1] == "A" else None

    @property
    def may_be_labels(self) -> bool:
        """Whether its values are labels where they are whole numbers."""
        is_called_so = are_labels(self.words) or self.types == ("uint",)
        return is_called_so and len(self.roles) == 1 and not self.is_light

    @property
    def words(self) -> frozenset[str]:
        """Those of its names and its channels' names."""
        names = self.name, *self.also, *(channel.name for channel in self.channels)
        return frozenset().union(*map(words_of, names))


def layers_of_part(
    spec: oiio.ImageSpec, part: int, taken: set[str], file_format: str
) -> Iterator[Layer]:
    """The layers of one part of a file.

    Parameters
    ----------
    spec : OpenImageIO.ImageSpec
        Its header. Channels without a name mean nothing.
    part : int
        Its number.
    taken : set of str
        Names of layers of the parts before it.
    file_format : str
        As of :class:`Layer`.

    Yields
    ------
    Layer
    """
    members = defaultdict(list)
    for number, (prefix, role) in enumerate(split_names(spec.channelnames)):
        is_alpha = not prefix and number == spec.alpha_channel
        if spec.channelnames[number]:
            members[prefix].append((number, "A" if is_alpha else role))
    for prefix, entries in members.items():
        numbers, roles = zip(*entries, strict=True)
        chosen, is_light = choose(roles)
        types = tuple(str(spec.channelformat(numbers[k])) for k in chosen)
        is_light = is_light and not is_data(prefix or name_of_part(spec))
        if file_format == "openexr":  # it has whole numbers for IDs alone
            is_light = is_light and "uint" not in types
        name, *also = _names(spec, part, prefix, is_light, len(members) == 1, taken)
        layer = Layer(
            name,
            part,
            tuple(numbers[k] for k in chosen),
            tuple(roles[k] for k in chosen),
            is_light,
            types,
            spec.deep,
            file_format,
            _size(spec),
            tuple(also),
        )
        has_own_names = name in ("", prefix)
        channels = [_channel(layer, spec, number, role, has_own_names) for number, role in entries]
        yield replace(layer, channels=tuple(channels))


def _size(spec):
    """Rows and columns of what is shown, as :mod:`stylit_ref.files.layers.pixels` reads it."""
    size = spec.full_height, spec.full_width
    return size[::-1] if spec.get_int_attribute("Orientation") in (5, 6, 7, 8) else size


def _channel(layer, spec, number, role, has_own_name):
    """A channel as a layer of its own; its name in the file may be that of others too."""
    own = spec.channelnames[number]
    last = own.rpartition(".")[2]
    also = [f"{name}.{end}" for name in (layer.name, *layer.also) if name for end in (last, role)]
    return replace(
        layer,
        name=own if has_own_name else f"{layer.name}.{last}",
        numbers=(number,),
        roles=(role,),
        is_light=layer.is_light and role in ("R", "G", "B", "Y"),
        types=(str(spec.channelformat(number)),),
        also=tuple(also if layer.name else [*also, role]),
    )


def _names(spec, part, prefix, is_light, is_whole_part, taken):
    """The name of a layer, and others that it also answers to."""
    part_name, views = name_of_part(spec), spec.getattribute("multiView") or [""]
    view = spec.getattribute("view") or views[0]
    own = prefix or part_name
    whole = f"{part_name}.{prefix}" if part_name and prefix else own
    also = [own, part_name, whole] if part_name and is_whole_part else [own, whole]
    if view and own:
        also += [f"{own}.{view}", f"{view}.{own}"]
    if view and is_light and not prefix:
        also.append(view)
    name = "" if part == 0 and not prefix else own
    if name in taken:  # the same name in several parts
        name = next((each for each in also if each not in taken), f"{own}.{part}")
    return name, *dict.fromkeys(each for each in also if each != name)


def name_of_part(spec: oiio.ImageSpec) -> str:
    """The name of a part of a file, empty where it has none."""
    return spec.getattribute("oiio:subimagename") or spec.getattribute("name") or ""
