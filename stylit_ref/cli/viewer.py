"""``stylit-ref viewer``: a page that shows a finished grid of views from any place between them."""

import argparse
import logging
import sys
from pathlib import Path

from stylit_ref.cli.fade_option import add_fade
from stylit_ref.cli.parser import Parser
from stylit_ref.cli.viewer_manifest import opaque_image, views_of_manifest
from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import check_distinct, check_folder, check_writable
from stylit_ref.files.disk.whole_file import write_bytes
from stylit_ref.notes import note
from stylit_ref.viewer.contents import make_contents
from stylit_ref.viewer.grid_views import GridViews
from stylit_ref.viewer.of_run import views_of_page
from stylit_ref.viewer.write_page import folder_texts, page_bytes, write_folder
from stylit_ref.views.run_folder import Run

LARGEST_PAGE = 32 * 10**6
"""Bytes that browsers and mail still take in one file."""

_USAGE = "%(prog)s RUN (--output FILE.html | --folder FOLDER) [options]"

_DESCRIPTION = """\
Write a page that shows what 'stylit-ref views --run RUN' has drawn from any place between its
views. A double click opens it; it needs no server and no network. For instance:

  stylit-ref viewer build/run --output house.html

docs/how_to/viewer.md shows the page and explains its controls."""


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "viewer",
        help="write a page that turns a finished grid of views",
        usage=_USAGE,
        description=_DESCRIPTION,
    )
    parser.set_defaults(command=run, parser=parser)
    parser.add_argument(
        "run", metavar="RUN",
        help="what 'views --run' wrote; or a manifest, FILE.json, that names pictures or NNFs of "
        "any other program",
    )  # fmt: skip
    to = parser.add_mutually_exclusive_group(required=True)
    to.add_argument("--output", "-o", metavar="FILE.html", help="write one file")
    to.add_argument(
        "--folder",
        metavar="FOLDER",
        help="or a folder, whose views are loaded when they are needed",
    )
    parser.add_argument(
        "--title", default="Stylized model", metavar="TEXT",
        help="what the page is called; screen readers read it (default '%(default)s')",
    )  # fmt: skip
    parser.add_argument(
        "--still", metavar="IMAGE",
        help="put the style in at this larger size, so that the page saves stills in it",
    )  # fmt: skip
    add_fade(parser)
    parser.add_argument("--quiet", action="store_true", help="print warnings and errors only")


def run(options: argparse.Namespace) -> None:
    """Read, pack, write; names are checked before."""
    if not 0 <= options.band <= 1:
        raise InputError(f"is {options.band:g}; it must be between 0 and 1", parameter="band")
    if options.output:
        if Path(options.output).suffix.lower() not in (".html", ".htm"):
            raise InputError(f"{options.output}: a page ends in .html", parameter="output")
        check_writable(options.output)
    else:
        check_folder(options.folder)
    views = _views(options.run, options.output)
    still = opaque_image(options.still) if options.still else None
    contents = make_contents(views, title=options.title, band=options.band, still=still)
    if views.orbit and not (views.mesh or views.points):
        note(f"{options.run}: has cameras and no mesh, so the page can only blend views; name one")
    if options.output:
        page = page_bytes(contents)
        write_bytes(options.output, page)
        size = len(page)
        if size > LARGEST_PAGE:
            note(
                f"{options.output}: has {_megabytes(size)}, and many programs refuse files of more "
                f"than {_megabytes(LARGEST_PAGE)}; write a folder by --folder",
                level=logging.WARNING,
            )
    else:
        texts = folder_texts(contents)
        write_folder(options.folder, texts)
        size = sum(len(text.encode()) for text in texts.values())
    if not options.quiet:
        growth = 1 if options.output else 4 / 3  # a folder holds base64
        weight = {piece.name: len(piece.packed) * growth for piece in contents.pieces}
        count = len(contents.facts["views"])
        page = options.output or Path(options.folder, "index.html")
        told = f"wrote {page} with {count} views, {_megabytes(size)}"
        told += "" if options.output else " with all that it loads"
        if "still" in weight:
            told += f"; the style for stills takes {_megabytes(weight['still'])} of it"
        print(told, file=sys.stderr)


def _views(run: str, output: str | None) -> GridViews:
    """The views of a RUN, or of a manifest."""
    if Path(run).suffix.lower() == ".json":
        return views_of_manifest(run)
    finished = Run(run)
    if output:
        check_distinct([output], finished.files)
    return views_of_page(finished)


def _megabytes(size: float) -> str:
    return f"{size / 1e6:.1f} MB"
