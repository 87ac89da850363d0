"""A digest of everything that a piece of code depends on: its files and all that they import.

Comments, docstrings and layout do not count. Neither do Python's own modules and installed
packages; Numba itself keeps the kernels of its versions apart. A file counts as a whole: code that
calls one of its functions depends on all of it. The ``__init__`` of a package is an exception,
since it often imports everything: only the names that are taken from it count.
"""

import ast
import hashlib
import sys
import sysconfig
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType
from typing import NamedTuple

INSTALLED = tuple(
    Path(sysconfig.get_path(name)).resolve()
    for name in ("stdlib", "platstdlib", "purelib", "platlib")
)
"""Folders of installed packages, which do not count."""

OWN = "stylit_ref", "gpu_cuda", "oracle", "data_gen", "eval"
"""Packages of this project, which count even if they are installed."""


def code_digest(*roots: Path | str | ModuleType, without: tuple[str, ...] = ()) -> str:
    """Identify the code of some files and of all that they import.

    Parameters
    ----------
    *roots : Path, str or module
        Python files, or modules that come from one.
    without : tuple of str
        Packages that do not count although they are imported, since this use does not run them.

    Returns
    -------
    str
        64 hexadecimal digits; they do not depend on the folder of the code.
    """
    digest = hashlib.sha256()
    for name, file in sorted((name, file) for file, name in _all_reached(roots, without).items()):
        digest.update(f"{name} {_source(file, name).digest}\n".encode())
    return digest.hexdigest()


def imported_files(*roots: Path | str | ModuleType) -> set[Path]:
    """The files that :func:`code_digest` covers."""
    return set(_all_reached(roots, ()))


def _all_reached(roots, without):
    names = {}
    for root in roots:
        file = Path(root.__file__ if isinstance(root, ModuleType) else root).resolve()
        names |= _reached(file, without)
    return names


@cache
def _reached(root, without):
    """The file and all files that it imports, each with the name of its module."""
    reached, waiting = {}, [(root, _module_name(root))]
    own = (*OWN, _module_name(root).partition(".")[0])
    while waiting:
        file, name = waiting.pop()
        if file not in reached:
            reached[file] = name
            waiting += _imported(file, name, without, own)
    return reached


@cache
def _imported(file, name, without, own):
    """The files that a file imports, with the names of their modules."""
    return [
        found
        for module, wanted in _source(file, name).imports
        if module.partition(".")[0] not in without
        for found in _resolved(module, wanted, own)
    ]


def _module_name(file):
    """Dotted name of a file's module: as it was imported, or from the packages around it."""
    for name, module in list(sys.modules.items()):
        if name != "__main__" and getattr(module, "__file__", None) == str(file):
            return name
    parts = [] if file.stem == "__init__" else [file.stem]
    for folder in file.parents:
        if not (folder / "__init__.py").exists():
            break
        parts.insert(0, folder.name)
    return ".".join(parts)


class _Source(NamedTuple):
    """The parts of a file that count: its syntax tree without docstrings, and its imports."""

    digest: str
    imports: list[tuple[str, str | None]]


@cache
def _source(file, name):
    tree = ast.parse(file.read_bytes())
    package = name if file.stem == "__init__" else name.rpartition(".")[0]
    imports, modules, nodes = [], {}, list(ast.walk(tree))
    for node in nodes:
        match node:
            case ast.Import(names=names):
                imports += [(alias.name, None) for alias in names]
                modules |= {alias.asname or alias.name.partition(".")[0]: alias for alias in names}
            case ast.ImportFrom(module=module, names=names, level=level):
                parents = package.split(".")[: 1 - level or None] if level else []
                origin = ".".join([*parents, *filter(None, [module])])
                imports += [(origin, alias.name) for alias in names]
            case (
                ast.Module(body=[ast.Expr(ast.Constant(str())), *rest])
                | ast.ClassDef(body=[ast.Expr(ast.Constant(str())), *rest])
                | ast.FunctionDef(body=[ast.Expr(ast.Constant(str())), *rest])
                | ast.AsyncFunctionDef(body=[ast.Expr(ast.Constant(str())), *rest])
            ):
                node.body = rest
    for chain in filter(None, map(_chain, nodes)):
        if chain[0] in modules:  # after "import a as b", b.c.d takes d from a.c
            alias = modules[chain[0]]
            path = [alias.name if alias.asname else chain[0], *chain[1:]]
            imports += [(".".join(path[:k]), path[k]) for k in range(1, len(path))]
    return _Source(hashlib.sha256(ast.dump(tree).encode()).hexdigest(), imports)


def _chain(node):
    """Names of an expression ``a.b.c``, or None."""
    names = []
    while isinstance(node, ast.Attribute):
        names.insert(0, node.attr)
        node = node.value
    return [node.id, *names] if names and isinstance(node, ast.Name) else None


def _resolved(module, wanted, own):
    """The files that an import makes a file depend on, with the names of their modules."""
    file = _file(module, own)
    if wanted is None:
        return [(file, module)] if file else []
    submodule = _file(f"{module}.{wanted}", own)
    if submodule:
        return [(submodule, f"{module}.{wanted}")]
    if file is None:
        return []
    if file.stem == "__init__":  # find the file that it imports the name from
        for origin, name in _source(file, module).imports:
            if name == wanted:
                return _resolved(origin, name, own)
    return [(file, module)]


@cache
def _file(module, own):
    """The file of a module; None if the module is installed or does not exist."""
    top, *rest = module.split(".")
    try:
        spec = find_spec(top)
    except (ImportError, ValueError):
        return None
    if spec is None:
        return None
    file = Path(spec.origin).resolve() if (spec.origin or "").endswith(".py") else None
    folders = [Path(folder).resolve() for folder in spec.submodule_search_locations or ()]
    places = [file] if file else folders
    if top not in own and any(place.is_relative_to(at) for place in places for at in INSTALLED):
        return None
    for part in rest:  # a package without an __init__ may have several folders
        found = [
            place
            for folder in folders
            for place in (folder / part / "__init__.py", folder / f"{part}.py")
            if place.exists()
        ]
        file = found[0] if found else None
        folders = [folder / part for folder in folders if (folder / part).is_dir()]
    return file
