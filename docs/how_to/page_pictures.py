"""Makes pictures of pages by their own commands: ``python -m docs.how_to.page_pictures [PAGE]``.

A page's blocks are run one after another, as a reader would, in a folder of their own. What they
wrote is put side by side. Transparent parts show a chessboard, and fields where pixels came from.
"""

import re
import subprocess
import sys
from os import environ, pathsep
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from skimage.io import imread, imsave
from skimage.transform import resize

from stylit_ref import read_nnf

HERE = Path(__file__).parent
ROOT = HERE.parents[1]
GAP = 6
SHEETS = {
    "alpha_and_colour": {
        "alpha_and_colour": ("data_gen/bundled/teapot/FULL.png", "background.png", "cut_out.png")
    },
    "how_to/completion": {"completion": ("wall.png+damage.png", "mended.png")},
    "how_to/embedding": {"embedding": tuple(f"levels/level_{k}.png" for k in (2, 3, 4, 6))},
    "how_to/still": {
        "still": (
            "scenes/source/FULL.png",
            "scenes/source/styles/oil.png",
            "scenes/helmet/FULL.png",
            "still.png",
        ),
        "field": ("still.png", "still.npy"),
        "passes": tuple(
            f"scenes/helmet/{name}.png" for name in ("FULL", "LDE", "LSE", "LDDE", "IDMASK")
        ),
    },
    "how_to/textures": {
        "../how_to/textures/texture": ("flowers.png", "texture.png"),
        "../how_to/textures/hole": ("pebbles.png+holes.png", "completed.png"),
        "../how_to/textures/several": ("by_labels.png", "by_shares.png", "by_guide.png"),
        "../how_to/textures/by_hand": ("painted.png", "dropped.png", "overlay.png"),
        "texture": ("texture.png",),
    },
    "how_to/tiling_texture": {
        "tiling_texture": ("pebbles.png", "texture.png", "tiled.png", "texture_normals.png")
    },
}
"""For each page its pictures in ``docs/pictures``, and the files that lie side by side in them.

``A+B`` is image A, white where mask B is.
"""


def run_page(page, folder):
    """Run what is on a page, block by block."""
    environment = environ | {
        "PATH": f"{Path(sys.executable).parent}{pathsep}{environ['PATH']}",
        "PYTHONPATH": str(ROOT),
    }
    text = (ROOT / "docs" / f"{page}.md").read_text(encoding="utf-8")
    for language, code in re.findall(r"^```(sh|python)\n(.*?)^```", text, re.DOTALL | re.MULTILINE):
        program = ["bash", "-ec"] if language == "sh" else [sys.executable, "-c"]
        subprocess.run([*program, code], cwd=folder, env=environment, check=True)


def shown(folder, name):
    """An image, a field as colours, or an image with its holes."""
    if name.endswith(".npy"):
        return places(read_nnf(f"{folder}/{name}").nnf)
    name, _, mask = name.partition("+")
    image = imread(f"{folder}/{name}")
    if mask:
        image[imread(f"{folder}/{mask}") >= 128] = 255
    if image.ndim == 2:
        image = np.dstack([image] * 3)
    return over_chessboard(image) if image.shape[2] == 4 else image


def places(nnf):
    """Where pixels came from: red to the right, green downwards."""
    scaled = nnf * 255 // nnf.max(axis=(0, 1))
    return np.dstack([scaled[..., 1], scaled[..., 0], np.full(nnf.shape[:2], 96)]).astype(np.uint8)


def over_chessboard(image):
    """An image with alpha, over squares of two greys."""
    y, x = np.indices(image.shape[:2]) // 8
    ground = np.where((y + x) % 2, 204, 255)[..., None]
    alpha = image[..., 3:] / 255
    return np.round(image[..., :3] * alpha + ground * (1 - alpha)).astype(np.uint8)


def beside(images):
    """Images side by side, as high as the last of them, with white between."""
    height = images[-1].shape[0]
    gap = np.full((height, GAP, 3), 255, np.uint8)
    row = [part for image in images for part in (gap, scaled(image, height))]
    return np.concatenate(row[1:], axis=1)


def scaled(image, height):
    """An image at a height: smaller by means, larger by squares."""
    shape = height, round(image.shape[1] * height / image.shape[0])
    if shape[0] == image.shape[0]:
        return image
    smaller = shape[0] < image.shape[0]
    made = resize(image, shape, order=int(smaller), anti_aliasing=smaller, preserve_range=True)
    return np.round(made).astype(np.uint8)


def main():
    """Run the pages named, or all, and save their pictures."""
    for page in sys.argv[1:] or SHEETS:
        with TemporaryDirectory() as folder:
            (Path(folder) / "data_gen").symlink_to(ROOT / "data_gen")
            run_page(page, folder)
            for sheet, names in SHEETS[page].items():
                sheet_image = beside([shown(folder, name) for name in names])
                if sheet == "texture":
                    sheet_image = sheet_image[38:218, 131:381]  # the middle, for a table
                file = ROOT / "docs" / "pictures" / f"{sheet}.webp"
                imsave(file, sheet_image, check_contrast=False)


if __name__ == "__main__":
    main()
