"""``stylit-ref layers``: what there is in an image file, and what each layer can serve as."""

import argparse
from collections.abc import Iterator
from pathlib import Path

from stylit_ref.cli.parser import Parser
from stylit_ref.errors import one_line
from stylit_ref.files.disk.paths import existing_file
from stylit_ref.files.layers.contents import Contents, contents_of
from stylit_ref.files.layers.cryptomatte import cryptomattes_of
from stylit_ref.files.layers.layer import Layer
from stylit_ref.files.layers.names import whole_name

_DESCRIPTION = """\
List the layers of an image file as the other commands call them, their channels, and what each can
serve as. A picture goes through the sRGB curve where it is floating point, data does not. What has
one channel can also be a mask. Labels are IDs: as a guide each has a colour of its own. A
Cryptomatte has a matte for each name, and without a name it is labels. For instance:

  stylit-ref layers scene.exr"""


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "layers", help="list the layers of an image file", description=_DESCRIPTION
    )
    parser.set_defaults(command=run, parser=parser)
    parser.add_argument("file", metavar="FILE", help="an image file, for instance scene.exr")


def run(options: argparse.Namespace) -> None:
    """Print a line for each layer."""
    file = existing_file(options.file)
    rows = list(_rows(file, contents_of(file)))
    widths = [max(len(row[column]) for row in rows) for column in (0, 1)]
    for name, channels, serves_as in rows:
        print(f"{name:{widths[0]}}  {channels:{widths[1]}}  {serves_as}")


def _rows(file: Path, contents: Contents) -> Iterator[tuple[str, str, str]]:
    """What one writes for each layer, its channels, and what it can serve as."""
    cryptomattes = cryptomattes_of(contents)
    ranks = {layer for cryptomatte in cryptomattes for layer in cryptomatte.ranks}
    names = {cryptomatte.name for cryptomatte in cryptomattes}
    for layer in contents.layers:
        if layer in ranks or layer.name in names:  # the other has a preview for people
            continue
        yield _row(file, layer)
        if not layer.is_deep:
            colours = set(layer.numbers[: layer.alpha_channel])
            for channel in layer.channels:
                if not colours.issuperset(channel.numbers):
                    yield _row(file, channel)
    for cryptomatte in cryptomattes:
        yield _shown(file, cryptomatte.name), "", "labels"
        name = _shown(file, f"{cryptomatte.name}/NAME")
        yield name, "", one_line(f"mask, data: Cryptomatte; {cryptomatte.manifest.known_names}")


def _row(file, layer):
    return _shown(file, layer.name), " ".join(map(one_line, layer.roles)), _serves_as(layer)


def _serves_as(layer: Layer) -> str:
    if layer.is_deep:
        return "nothing: its pixels are deep; oiiotool --flatten makes a picture of them"
    if layer.may_be_labels and layer.types == ("uint",):  # too large for the others
        return "labels"
    uses = ["mask"] if len(layer.roles) == 1 else []
    uses.append("picture" if layer.is_light else "data")
    return ", ".join([*uses, "labels"] if layer.may_be_labels else uses)


def _shown(file, name):
    return one_line(whole_name(file, name))
