"""Write a page: one file, or a folder whose views are loaded as they are needed."""

import base64
import json
from collections.abc import Mapping
from dataclasses import replace
from html import escape
from importlib.resources import files
from pathlib import Path
from string import Template

from stylit_ref.files.disk.whole_file import write_text
from stylit_ref.viewer.contents import Contents
from stylit_ref.viewer.embedding import ascii_text, embedded
from stylit_ref.viewer.pieces import Piece

FOLDER = "data"
"""Where the pieces of a page lie that is a folder."""

PROBE = "stylit-probe"
"""What shows a page whether its bytes came as they were written."""

_CALL = 'stylitPiece("'
"""How the script of a piece begins."""

PROGRAM, STYLE_SHEET, PAGE = "bundle/viewer.js", "page.css", "page.html"


def page_bytes(contents: Contents) -> bytes:
    """The page as one file.

    Parameters
    ----------
    contents : Contents

    Returns
    -------
    bytes
        HTML in windows-1252, which needs no other file and no network.
    """
    packed = {PROBE: b"\xff"} | {piece.name: piece.packed for piece in contents.pieces}
    pieces = "".join(
        f'<script type="application/octet-stream" id="{name}">{embedded(each)}</script>\n'
        for name, each in packed.items()
    )
    return _page(contents, f"<script>\n{_part(PROGRAM)}</script>", pieces).encode("latin-1")


def folder_texts(contents: Contents) -> Mapping[str, str]:
    """The page as a folder: its files by their names.

    Parameters
    ----------
    contents : Contents

    Returns
    -------
    mapping of str to str
        ``index.html``, its program, and a script for each piece: browsers load no other files
        from the disk. All are ASCII, since servers tell what encoding scripts have.
    """
    contents = replace(contents, facts=contents.facts | {"folder": FOLDER})
    page = _page(contents, '<script src="viewer.js"></script>', "")
    scripts = {
        f"{FOLDER}/{piece.name}.js": f'{_CALL}{piece.name}", "{_base64(piece)}");\n'
        for piece in contents.pieces
    }
    return {"index.html": page, "viewer.js": _part(PROGRAM), **scripts}


def write_folder(folder: str | Path, texts: Mapping[str, str]) -> None:
    """Write the files of a page, ``index.html`` last; pieces of an earlier page are taken away.

    Raises
    ------
    InputError
        If one cannot be written.
    """
    for name in sorted(texts, key=lambda name: name == "index.html"):
        write_text(Path(folder) / name, texts[name])
    for script in (Path(folder) / FOLDER).glob("*.js"):
        if f"{FOLDER}/{script.name}" not in texts and _is_piece(script):
            script.unlink()


def _is_piece(script: Path) -> bool:
    with script.open("rb") as file:
        return file.read(len(_CALL)) == _CALL.encode()


def _page(contents, script, pieces):
    # Within a script a tag would end it.
    data = json.dumps(contents.facts, allow_nan=False).replace("<", "\\u003c")
    title = ascii_text(escape(contents.facts["title"]))
    return Template(_part(PAGE)).substitute(
        title=title, css=_part(STYLE_SHEET), script=script, data=data, pieces=pieces
    )


def _part(name):
    return files("stylit_ref.viewer").joinpath(name).read_text(encoding="utf-8")


def _base64(piece: Piece):
    return base64.b64encode(piece.packed).decode()
