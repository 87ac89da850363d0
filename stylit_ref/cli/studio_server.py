"""Open a studio and serve it: what its options name is read, its address shown."""

import argparse
import logging
import sys
import webbrowser
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from functools import partial
from threading import Thread

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.bundled_scenes import bundled_style
from stylit_ref.errors import InputError
from stylit_ref.files.disk.paths import existing_file, is_there, real_path
from stylit_ref.notes import note
from stylit_ref.studio.engine.events import Event
from stylit_ref.studio.engine.live import Live
from stylit_ref.studio.engine.scene import Scene
from stylit_ref.studio.painting.folder import PaintingFolder
from stylit_ref.studio.painting.held import held
from stylit_ref.studio.scene_files.shelf import Shelf
from stylit_ref.studio.server.access import Access
from stylit_ref.studio.server.beginning import Beginning, begin
from stylit_ref.studio.server.door import USUAL_PORT, open_door, port_of
from stylit_ref.studio.server.panel import Panel
from stylit_ref.studio.server.serve import serve
from stylit_ref.studio.server.views_panel import views_panel
from stylit_ref.studio.server.way_in import way_in

_PORTS = range(1024, 65536)
"""Those below are the system's."""


def serve_studio(options: argparse.Namespace, shelf: Shelf) -> None:
    """Serve until the program is interrupted.

    Parameters
    ----------
    options : argparse.Namespace
        Of ``stylit-ref studio``.
    shelf : Shelf

    Raises
    ------
    InputError
        If something that they name cannot be used.
    KeyboardInterrupt
        When interrupted; the painting is saved.
    """
    _check_port(options.port)
    panels = _panels(options)
    folder = PaintingFolder(options.painting)
    try:
        with held(folder.folder), _failures_on_stderr():
            _serve(options, _beginning(options, shelf, folder), panels)
    except KeyboardInterrupt:
        saved = folder.style.exists()
        left = f"the painting is saved in {folder.folder}" if saved else "nothing was painted"
        raise KeyboardInterrupt(left) from None


def _beginning(options: argparse.Namespace, shelf: Shelf, folder: PaintingFolder) -> Beginning:
    """What there is to paint on."""
    style, watched = options.style, options.watch
    if style and options.source is None and not is_there(style):
        style = bundled_style(style)
    if watched and real_path(watched) == real_path(folder.style):
        raise InputError(
            f"is {watched}, where the studio itself saves; watch another file", parameter="watch"
        )
    return begin(shelf, folder, style=style, watched=watched)


def _serve(options: argparse.Namespace, beginning: Beginning, panels: list[Panel]) -> None:
    door = open_door(options.port)
    access = Access(port_of(door))
    if options.port is None and access.port != USUAL_PORT:
        note(f"port {USUAL_PORT} is taken, so the studio is at {access.port}")

    def listens(browsed: str | None) -> None:
        print(f"The studio is at {access.address}", flush=True)
        if not options.quiet:
            for text in beginning.notes:
                print(text, file=sys.stderr)
            print("Ctrl-C saves the painting and ends.", file=sys.stderr)
        if browsed:  # a browser in the terminal returns when it is left
            Thread(target=webbrowser.open, args=(browsed,), daemon=True).start()

    def engine(
        scene: Scene, painting: NDArray[np.uint8], tell: Callable[[Event], None], seed: int
    ) -> Live:
        return Live(scene, painting, tell=tell, threads=options.threads, seed=seed)

    folder = beginning.folder.folder
    with nullcontext() if options.no_browser else way_in(folder, access.address) as browsed:
        serve(
            beginning, engine, door, access, panels=panels, listens=partial(listens, browsed)
        )  # fmt: skip


@contextmanager
def _failures_on_stderr() -> Iterator[None]:
    """Print failures of the studio itself whole, so that they can be reported."""
    logger, handler = logging.getLogger("stylit_ref.studio"), logging.StreamHandler()
    logger.addHandler(handler)
    logger.propagate = False  # else they would be notes as well
    try:
        yield
    finally:
        logger.propagate = True
        logger.removeHandler(handler)


def _check_port(port: int | None) -> None:
    if port and port not in _PORTS:
        raise InputError(f"is {port}; it must be 0, or from 1024 to 65535", parameter="port")


def _panels(options: argparse.Namespace) -> list[Panel]:
    """Those whose rooms are installed, and whose options are given."""
    panels = []
    try:
        from stylit_ref.studio.server.scan_panel import scan_panel

        panels.append(scan_panel())
    except ModuleNotFoundError as error:
        _tell_absent("scans", error)
    if options.texture:
        try:
            from stylit_ref.studio.server.texture_panel import read_texture, texture_panel

            panels.append(texture_panel(read_texture(existing_file(options.texture))))
        except ModuleNotFoundError as error:
            _tell_absent("textures", error)
    if options.views:
        try:
            from stylit_ref.cli.studio_views import views_page

            panels.append(views_panel(views_page(options.views)))
        except ModuleNotFoundError as error:
            _tell_absent("views", error)
    return panels


def _tell_absent(what: str, error: ModuleNotFoundError) -> None:
    note(f"the page has no {what}, since {error.name} is missing", level=logging.WARNING)
