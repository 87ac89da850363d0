"""Make a data set, piece by piece; what is finished is not made again.

Layout of the folder::

    manifest.json
    source/passes.exr  source/FULL.png  source/LDE.png  ...
    source/styles/crayon.png  ...
    teapot/passes.exr  teapot/FULL.png  ...
    house/source/passes.exr  house/source/FULL.png  ...
    house/1_1/passes.exr  house/1_1/FULL.png  ...   row and column of the view
    house/motion/1_1_to_1_2.exr                     MOTION.X, MOTION.Y, VISIBLE.Y
"""

import shutil
from contextlib import contextmanager
from pathlib import Path

from skimage.io import imsave
from tqdm import tqdm

from data_gen.camera import GRID
from data_gen.guides import LIMITS, guide, to_uint8
from data_gen.manifest import Manifest, recipe
from data_gen.models import TARGETS
from data_gen.multilayer_exr import write_layers
from data_gen.renderer import start

SCENES = (*TARGETS, "house")


def produce(folder, size, scenes=SCENES, samples=64, seed=0, exr=True):
    """Render and paint what is not there yet.

    Parameters
    ----------
    folder : str or Path
    size : (int, int)
        Width, height.
    scenes : iterable of str
        Of ``SCENES``; the source and the styles always belong to them.
    samples : int
        A pixel.
    seed : int
    exr : bool
        Keep the layers of each view, not only the guides made from them.

    Returns
    -------
    list of str
        The pieces made now; others were there.

    Raises
    ------
    DataError
        If the folder holds other files.
    MissingRendererError
        If something has to be rendered and the renderer is not installed.
    """
    folder = Path(folder)
    manifest = Manifest.open(folder)
    asked = recipe(size, samples, seed, exr)
    pieces = _pieces(scenes)
    if manifest.recipe == asked:
        pieces = [piece for piece in pieces if not manifest.complete(piece)]
    if not pieces:
        return []
    start()
    manifest.restart(asked)
    from data_gen.rendering import Rendering  # imports what start() looks for

    rendering = Rendering(size, samples, seed)
    with tqdm(pieces, unit="piece", disable=None) as bar:
        for piece in bar:
            bar.set_description(piece)
            with _partial(folder) as partial:
                _make(piece, partial, rendering, exr)
                shutil.rmtree(folder / piece, ignore_errors=True)
                (folder / piece).parent.mkdir(exist_ok=True)
                partial.rename(folder / piece)
            manifest.add(piece)
    return pieces


@contextmanager
def _partial(folder):
    """A folder for what is not finished, gone afterwards; one of a killed process goes first."""
    partial = folder / "partial"
    shutil.rmtree(partial, ignore_errors=True)
    partial.mkdir()
    try:
        yield partial
    finally:
        shutil.rmtree(partial, ignore_errors=True)


def _make(piece, folder, rendering, exr):
    if piece == "house/motion":
        for name, layers in rendering.motion():
            write_layers(folder / f"{name}.exr", layers)
        return
    layers = rendering.view(piece)
    _write_view(folder, layers, LIMITS["house" if piece.startswith("house") else "stage"], exr)
    if piece == "source":
        _paint(folder / "styles", layers)


def _pieces(scenes):
    pieces = ["source"]
    for scene in dict.fromkeys(scenes):
        if scene == "house":
            views = ("source", *(f"{row}_{column}" for row, column in GRID), "motion")
            pieces += [f"house/{view}" for view in views]
        else:
            pieces.append(scene)
    return pieces


def _write_view(folder, layers, limits, exr):
    if exr:
        write_layers(folder / "passes.exr", layers)
    for name, layer in layers.items():
        image = guide(name, layer, limits)
        imsave(folder / f"{name}.png", image.squeeze(), check_contrast=False)


def _paint(folder, layers):
    from data_gen.styles import STYLES, subject  # imports what start() looks for

    folder.mkdir()
    seen = subject(layers)
    for name, paint in STYLES.items():
        imsave(folder / f"{name}.png", to_uint8(paint(seen)), check_contrast=False)
