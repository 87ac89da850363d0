"""What there is in an image file: its layers, and what is left out of it."""

from dataclasses import dataclass, field
from pathlib import Path

import OpenImageIO as oiio

from stylit_ref.errors import InputError
from stylit_ref.files.disk.bmp_header import channel_numbers
from stylit_ref.files.disk.image_file import check_size, open_image
from stylit_ref.files.disk.png_chunks import read_chunks
from stylit_ref.files.layers.layer import Layer, layers_of_part, name_of_part

_FIRST_IS_READ = "holds several images; the first is read"


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
        has_name = any("." in name for name in spec.channelnames) or name_of_part(spec)
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
    contents.layers.extend(layers_of_part(spec, part, taken, file_format))


def _name_channels_of_bmp(file, spec):
    """Name the channels as the header of the file does, and those that mean nothing not at all."""
    numbers = channel_numbers(file)
    if numbers:
        names = {number: role for role, number in numbers.items()}
        spec.channelnames = tuple(names.get(number, "") for number in range(spec.nchannels))
        spec.alpha_channel = numbers.get("A", -1)


def _said_of_cryptomatte(spec):
    names = [each.name for each in spec.extra_attribs if "cryptomatte/" in each.name]
    return {name: str(spec.getattribute(name)) for name in names}
