"""``stylit-ref studio``: a page to paint on, beside the picture that follows."""

import argparse
import sys
from pathlib import Path

from stylit_ref.cli.bundled_scenes import bundled_offers, bundled_source
from stylit_ref.cli.parameter_options import whole_number
from stylit_ref.cli.parser import Parser
from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import check_writable
from stylit_ref.files.disk.whole_file import write_bytes
from stylit_ref.machine.thread_count import check_threads
from stylit_ref.studio.scene_files.offer import offer_of_files
from stylit_ref.studio.scene_files.shelf import Shelf

_USAGE = "%(prog)s [TARGET ...] [options]"

_DESCRIPTION = """\
Open a page in the browser: on the left the sphere to paint on, on the right the picture that
follows while you paint. Nothing leaves this machine. The painting is saved as you go, in a folder
from which the next call goes on:

  stylit-ref studio --painting build/painting

Paint on your own renders, a folder or an EXR file on each side, and in a program of your own:

  stylit-ref studio renders/robot --source renders/sphere --watch robot.png"""

_EXTRA = "starlette", "uvicorn", "websockets"
"""Packages that only the studio needs."""


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "studio",
        help="paint, and see the picture follow, in the browser",
        usage=_USAGE,
        description=_DESCRIPTION,
    )
    parser.set_defaults(command=run, parser=parser)
    parser.add_argument(
        "targets", nargs="*", metavar="TARGET",
        help="what is stylized: a folder of render passes, or an EXR file; several to choose from "
        "(default: the bundled scenes)",
    )  # fmt: skip
    painting = parser.add_argument_group("the painting")
    painting.add_argument(
        "--source", metavar="SOURCE",
        help="what is painted over, with the same passes (default: the bundled sphere)",
    )  # fmt: skip
    painting.add_argument(
        "--painting", default="painting", metavar="FOLDER",
        help="where the painting is saved, and read again (default ./%(default)s)",
    )  # fmt: skip
    painting.add_argument(
        "--style", metavar="IMAGE",
        help="begin a new painting with this: an image as large as the source, or the name of one "
        "that is bundled, oil, crayon, watercolour or pen (default: the render)",
    )  # fmt: skip
    painting.add_argument(
        "--watch", metavar="IMAGE",
        help="paint in a program of your own: whenever this file changes, it becomes the painting. "
        "If there is none, it is written",
    )  # fmt: skip
    painting.add_argument(
        "--sheet", metavar="FILE.pdf",
        help="write a sheet to print, to paint on, and to photograph in the studio; then end",
    )  # fmt: skip
    more = parser.add_argument_group("more on the page")
    more.add_argument(
        "--views", metavar="RUN", help="show what 'views --run' wrote, as 'viewer' does"
    )
    more.add_argument(
        "--texture", metavar="IMAGE", help="a texture like this, to drop patches on and paint with"
    )
    machine = parser.add_argument_group("the machine")
    machine.add_argument(
        "--port", type=whole_number, metavar="N",
        help="listen at this port of 127.0.0.1, from 1024, or 0 for any (default: 8517, or the "
        "next that is free)",
    )  # fmt: skip
    machine.add_argument(
        "--no-browser", action="store_true", help="only print the address, and open no browser"
    )
    machine.add_argument(
        "--threads", type=whole_number, metavar="N", help="threads to use (default: all)"
    )
    machine.add_argument("--quiet", action="store_true", help="print warnings and errors only")


def run(options: argparse.Namespace) -> None:
    """Write a sheet, or open the studio and serve it until it is interrupted."""
    check_threads(options.threads)
    shelf = _shelf(options.targets, options.source)
    if options.sheet:
        _write_sheet(options.sheet, shelf, quiet=options.quiet)
        return
    try:
        from stylit_ref.cli.studio_server import serve_studio
    except ModuleNotFoundError as error:
        package = (error.name or "").partition(".")[0]
        if package not in _EXTRA:
            raise
        raise InputError(
            f"the studio needs the package {package!r}; pip install 'stylit-ref[studio]'"
        ) from None
    serve_studio(options, shelf)


def _shelf(targets: list[str], source: str | None) -> Shelf:
    """The scenes that the options name, or those that are bundled."""
    if not targets:
        if source:
            raise InputError("is of no use without a TARGET; name one", parameter="source")
        return Shelf(list(bundled_offers()))
    names = (Path(target).resolve().stem for target in targets)
    numbered = [f"{number}_{name}" for number, name in enumerate(names, 1)]
    painted = source or bundled_source()
    return Shelf(
        [
            offer_of_files(name, painted, target)
            for name, target in zip(numbered, targets, strict=True)
        ]
    )


def _write_sheet(file: str, shelf: Shelf, *, quiet: bool) -> None:
    from stylit_ref.studio.sheet.print_sheet import print_sheet

    if Path(file).suffix.lower() != ".pdf":
        raise InputError(f"{file}: a sheet ends in .pdf", parameter="sheet")
    check_writable(file)
    write_bytes(file, print_sheet(shelf.first.rendering(), shelf.first.things()))
    if not quiet:
        print(f"wrote {file}; print it at its full size", file=sys.stderr)
