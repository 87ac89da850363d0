"""Digests of code, which results are kept under: taken once, when a program starts."""

import ast
import hashlib
from functools import cache
from pathlib import Path

_CHECKOUT = Path(__file__).parents[1]


def code_of(*files):
    """Digest of some files and of all that they import from the checkout.

    Comments and docstrings change nothing.

    Parameters
    ----------
    *files : str or Path

    Returns
    -------
    str
    """
    found, waiting = {}, [Path(file).resolve() for file in files]
    while waiting:
        file = waiting.pop()
        if file not in found:
            found[file], imported = _parsed(file)
            waiting += imported
    digest = hashlib.sha256()
    for file in sorted(found):
        digest.update(f"{file.relative_to(_CHECKOUT)} {found[file]}\n".encode())
    return digest.hexdigest()[:16]


@cache
def _parsed(file):
    """What a file says without its text, and the files it imports."""
    tree = ast.parse(file.read_bytes())
    imported = tuple(_imported(tree))
    return _without_text(tree), imported


def _imported(tree):
    """Files of the checkout that are imported, a package's own only where it is named."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            files = [_file_of(alias.name) for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            files = [
                _file_of(f"{node.module}.{alias.name}") or _file_of(node.module)
                for alias in node.names
            ]
        else:
            continue
        yield from filter(None, files)


def _file_of(module):
    place = _CHECKOUT.joinpath(*module.split("."))
    files = place.with_suffix(".py"), place / "__init__.py"
    return next((file for file in files if file.is_file()), None)


def _without_text(tree):
    for node in ast.walk(tree):
        body = getattr(node, "body", None)
        if isinstance(body, list):
            node.body = [statement for statement in body if not _is_text(statement)]
    return ast.dump(tree)


def _is_text(statement):
    return isinstance(statement, ast.Expr) and isinstance(statement.value, ast.Constant)
