"""The manifest of ``stylit-ref viewer``: views of any method, as NNFs or as pictures alone.

``docs/how_to/viewer.md`` describes it.
"""

import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.scene_files import SceneFiles
from stylit_ref.cli.views_manifest import VIEW
from stylit_ref.errors import InputError, did_you_mean
from stylit_ref.files.disk.paths import check_regular, existing_file
from stylit_ref.files.nnf_file import read_nnf
from stylit_ref.files.read_image import read_uint8
from stylit_ref.viewer.grid_views import GridViews, opaque
from stylit_ref.views.interpolation.camera import read_camera
from stylit_ref.views.interpolation.centred import centred
from stylit_ref.views.interpolation.orbit import grid_of_steps, orbit_of

_KEYS = "grid", "nnfs", "style", "patch_width", "pictures", "cameras", "mesh"


def views_of_manifest(path: str) -> GridViews:
    """Read a manifest; views are read when they are packed.

    Parameters
    ----------
    path : str
        A JSON file; the names in it lead from its folder.

    Returns
    -------
    GridViews

    Raises
    ------
    InputError
        If it cannot be read, lacks something, has a key that means nothing, or a view does not fit.
    """
    file = existing_file(path)
    check_regular(file)
    try:
        return _views(json.loads(file.read_text(encoding="utf-8")), file.parent, path)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except ValueError as error:
        if isinstance(error, InputError):
            raise
        raise InputError(f"{path}: is no JSON: {error}") from None


def _views(content: Any, folder: Path, path: str) -> GridViews:
    if not isinstance(content, dict):
        raise InputError(f"{path}: is not an object with the keys {', '.join(_KEYS)}")
    if "guides" in content:
        raise InputError(
            f"{path}: is a manifest of 'stylit-ref views', whose views are still to be drawn; run "
            f"stylit-ref views --manifest {path} --output '{VIEW}.png' --run RUN, and name RUN in "
            "place of the manifest"
        )
    if strange := [key for key in content if key not in _KEYS]:
        known = f"known are {', '.join(_KEYS)}{did_you_mean(strange[0], _KEYS)}"
        raise InputError(f"{path}: has {strange[0]!r}; {known}")
    names, rows, columns = _names(content.get("grid"), path)
    kind = "nnfs" if "nnfs" in content else "pictures"
    template = content.get(kind)
    if not isinstance(template, str) or VIEW not in template:
        raise InputError(f"{path}: needs nnfs or pictures, a text in which {VIEW} names a view")
    if kind == "nnfs" and not isinstance(content.get("style"), str):
        raise InputError(f"{path}: needs style, the image that nnfs point into")
    files = [str(folder / template.replace(VIEW, name)) for name in names]
    style = opaque_image(str(folder / content["style"])) if kind == "nnfs" else None
    width = content.get("patch_width", 5)
    if not isinstance(width, int) or width % 2 == 0 or not 1 <= width <= 15:
        raise InputError(f"{path}: patch_width is {width!r}; it must be odd, from 1 to 15")
    first = opaque_image(files[0]) if style is None else read_nnf(files[0]).nnf
    size = first.shape[0], first.shape[1]

    def view(frame: int) -> NDArray[Any]:
        found = opaque_image(files[frame]) if style is None else read_nnf(files[frame]).nnf
        if found.shape[:2] != size:
            raise InputError(
                f"{files[frame]}: is {found.shape[1]}x{found.shape[0]}, and {files[0]} is "
                f"{size[1]}x{size[0]}; all views must have one size"
            )
        if style is not None:
            _check_reach(found, style.shape[:2], width, files[frame])
        return found

    if not isinstance(content.get("mesh", ""), str):
        raise InputError(f"{path}: mesh is {content['mesh']!r}; it must be the name of a file")
    if "mesh" in content and "cameras" not in content:
        raise InputError(f"{path}: has a mesh and no cameras; name the camera of every view")
    if "cameras" not in content:
        return GridViews(grid_of_steps(rows, columns), size, style, width, view)
    facts = content["cameras"]
    if not isinstance(facts, dict):
        raise InputError(f"{path}: cameras must be an object with one for each view")
    try:
        orbit = orbit_of([read_camera(facts.get(name), name) for name in names], rows, columns)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None
    mesh = SceneFiles(str(folder / content["mesh"])).read_mesh() if "mesh" in content else None
    if mesh is not None:
        mesh, orbit = centred(mesh, orbit)
    return GridViews(orbit.grid, size, style, width, view, orbit, mesh)


def opaque_image(path: str) -> NDArray[np.uint8]:
    """An image as red, green and blue; on white where it is transparent."""
    return opaque(np.atleast_3d(read_uint8(path)), path)


def _names(grid: Any, path: str) -> tuple[list[str], int, int]:
    is_grid = isinstance(grid, list) and grid and all(isinstance(row, list) for row in grid)
    names = [name for row in grid for name in row] if is_grid else []
    is_whole = is_grid and len({len(row) for row in grid}) == 1
    if not is_whole or len(set(map(str, names))) < 2 or not all(isinstance(n, str) for n in names):
        raise InputError(
            f"{path}: grid must be a list of rows, each with as many names of views, at least two "
            "in all"
        )
    return names, len(grid), len(grid[0])


def _check_reach(nnf: NDArray[np.int32], size: tuple[int, ...], width: int, file: str) -> None:
    radius = width // 2
    low, high = nnf.min(axis=(0, 1)), nnf.max(axis=(0, 1))
    if (low < radius).any() or (high > np.array(size) - 1 - radius).any():
        raise InputError(
            f"{file}: points to source pixels (y, x) from {low.tolist()} to {high.tolist()}, and "
            f"patches of width {width} lie within the style only from {[radius, radius]} to "
            f"{[side - 1 - radius for side in size]}"
        )
