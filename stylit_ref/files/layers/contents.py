"""Layers of an image file: of an EXR those that its channels' names or its parts' names tell."""

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path

import OpenImageIO as oiio

from stylit_ref.errors import InputError
from stylit_ref.files.disk.bmp_header import channel_numbers
from stylit_ref.files.disk.image_file import check_size, open_image
from stylit_ref.files.disk.png_chunks import read_chunks
from stylit_ref.files.layers.channels import are_labels, choose, is_data, split_names, words_of

_FIRST_IS_READ = "holds several images; the first is read"


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


@dataclass
class Contents:
    """What there is in an image file.

    Attributes
    ----------
    file : Path
    layers : list of Layer
    cryptomatte : dict of str to str
        What the headers of all parts say about Cryptomatte.
    left_out : str
        What is told of other images that have no name: frames, pages or sizes.
    """

    file: Path
    layers: list[Layer] = field(default_factory=list)
    cryptomatte: dict[str, str] = field(default_factory=dict)
    left_out: str = ""


def contents_of(file: str | Path) -> Contents:
    """List what there is in an image file.

    Raises
    ------
    InputError
        If it cannot be read.
    """
    try:
        return _contents_of(file)
    except UnicodeDecodeError:
        raise InputError(f"{file}: cannot be read: a name in its header is not UTF-8") from None


def _contents_of(file):
    image = open_image(file)
    contents = Contents(Path(file))
    if image.format_name() == "ico":
        _add_largest(contents, image)
    else:
        _add_parts(contents, image)
    if b"acTL" in read_chunks(file):  # frames of a PNG file, of which OpenImageIO does not know
        contents.left_out = _FIRST_IS_READ
    image.close()
    return contents


def _add_parts(contents: Contents, image: oiio.ImageInput) -> None:
    part = 0
    while image.seek_subimage(part, 0):
        spec = image.spec()
        has_name = any("." in name for name in spec.channelnames) or _part_name(spec)
        if part and not has_name:
            contents.left_out = _FIRST_IS_READ
            break
        _add_part(contents, image, part)
        part += 1


def _add_largest(contents: Contents, image: oiio.ImageInput) -> None:
    """Add what there is in the largest image of an icon, of several the one of most colours."""
    sizes, part = [], 0
    while image.seek_subimage(part, 0):
        spec = image.spec()
        bits = spec.get_int_attribute("oiio:BitsPerSample", 8)
        sizes.append((spec.width * spec.height, bits))
        part += 1
    if part > 1:
        contents.left_out = "holds several images; the largest is read"
    largest = sizes.index(max(sizes))
    image.seek_subimage(largest, 0)
    _add_part(contents, image, largest)


def _add_part(contents: Contents, image: oiio.ImageInput, part: int) -> None:
    """Add what there is in the part that the image stands at."""
    spec, file_format = image.spec(), image.format_name()
    if file_format != "openexr":  # others are decoded whole
        check_size(contents.file, spec, spec.nchannels)
    if file_format == "bmp":
        _name_channels_of_bmp(contents.file, spec)
    contents.cryptomatte |= _said_of_cryptomatte(spec)
    taken = {layer.name for layer in contents.layers}
    contents.layers.extend(_layers_of_part(spec, part, taken, file_format))


def _name_channels_of_bmp(file, spec):
    """Name the channels as the header of the file does, and those that mean nothing not at all."""
    numbers = channel_numbers(file)
    if numbers:
        names = {number: role for role, number in numbers.items()}
        spec.channelnames = tuple(names.get(number, "") for number in range(spec.nchannels))
        spec.alpha_channel = numbers.get("A", -1)


def _layers_of_part(
    spec: oiio.ImageSpec, part: int, taken: set[str], file_format: str
) -> Iterator[Layer]:
    members = defaultdict(list)
    for number, (prefix, role) in enumerate(split_names(spec.channelnames)):
        is_alpha = not prefix and number == spec.alpha_channel
        if role:
            members[prefix].append((number, "A" if is_alpha else role))
    for prefix, entries in members.items():
        numbers, roles = zip(*entries, strict=True)
        chosen, is_light = choose(roles)
        types = tuple(str(spec.channelformat(numbers[k])) for k in chosen)
        is_light = is_light and not is_data(prefix or _part_name(spec))
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
            tuple(also),
        )
        has_own_names = name in ("", prefix)
        channels = [_channel(layer, spec, number, role, has_own_names) for number, role in entries]
        yield replace(layer, channels=tuple(channels))


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
    part_name, views = _part_name(spec), spec.getattribute("multiView") or [""]
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


def _said_of_cryptomatte(spec):
    names = [each.name for each in spec.extra_attribs if "cryptomatte/" in each.name]
    return {name: str(spec.getattribute(name)) for name in names}


def _part_name(spec):
    return spec.getattribute("oiio:subimagename") or spec.getattribute("name") or ""
