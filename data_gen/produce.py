"""Make a data set, piece by piece; finished pieces are not made again.

Layout of the folder::

    manifest.json
    source/passes.exr  source/FULL.png  source/LDE.png  ...
    source/styles/crayon.png  ...
    teapot/passes.exr  teapot/FULL.png  ...
    house/source/passes.exr  house/source/FULL.png  ...
    house/1_1/passes.exr  house/1_1/FULL.png  ...   row and column of the view
    house/motion/1_1_to_1_2.exr                     MOTION.X, MOTION.Y, VISIBLE.Y
    turning/00/passes.exr  turning/00/FULL.png  ...  frame
    turning/motion/00_to_01.exr  turning/motion/01_to_00.exr
"""

import shutil
from contextlib import contextmanager
from pathlib import Path

from tqdm import tqdm

from data_gen.manifest import Manifest, recipe
from data_gen.renderer import start
from data_gen.scenes import SCENES, SOURCE, USUAL


def produce(folder, size, scenes=USUAL, samples=64, seed=0, exr=True):
    """Render and paint the missing pieces.

    Parameters
    ----------
    folder : str or Path
    size : (int, int)
        Width, height.
    scenes : iterable of str
        Names in :data:`data_gen.scenes.SCENES`; the source and the styles are always made.
    samples : int
        Samples a pixel.
    seed : int
    exr : bool
        Keep the layers of each view, not only the guides made from them.

    Returns
    -------
    list of str
        Names of the pieces that were made now.

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
    pieces = [SOURCE, *(piece for scene in scenes for piece in SCENES[scene])]
    pieces = list({piece.name: piece for piece in pieces}.values())
    if manifest.recipe == asked:
        pieces = [piece for piece in pieces if not manifest.complete(piece.name)]
    if not pieces:
        return []
    start()
    manifest.restart(asked)
    from data_gen.rendering import Rendering  # start() must have found the renderer before

    rendering = Rendering(size, samples, seed)
    with tqdm(pieces, unit="piece", disable=None) as bar:
        for piece in bar:
            bar.set_description(piece.name)
            with _partial(folder) as partial:
                piece.make(partial, rendering, exr)
                shutil.rmtree(folder / piece.name, ignore_errors=True)
                (folder / piece.name).parent.mkdir(exist_ok=True)
                partial.rename(folder / piece.name)
            manifest.add(piece.name)
    return [piece.name for piece in pieces]


@contextmanager
def _partial(folder):
    """A folder for unfinished files, empty at first and removed at the end."""
    partial = folder / "partial"
    shutil.rmtree(partial, ignore_errors=True)
    partial.mkdir()
    try:
        yield partial
    finally:
        shutil.rmtree(partial, ignore_errors=True)
