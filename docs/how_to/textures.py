"""Makes the pictures of ``textures.md`` by its own commands: ``python -m docs.how_to.textures``."""

import os
import re
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from skimage.io import imread, imsave

PAGE = Path(__file__).with_suffix(".md")
PICTURES = PAGE.with_suffix("")
ROOT = Path(__file__).parents[2]
SHEETS = {
    "texture": ("flowers", "texture"),
    "hole": ("pebbles", "completed"),
    "several": ("by_labels", "by_shares", "by_guide"),
    "by_hand": ("painted", "dropped", "overlay"),
}


def run_page(folder):
    """Run what is on the page, block by block."""
    environment = os.environ | {
        "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
        "PYTHONPATH": str(ROOT),
    }
    blocks = re.findall(r"```(sh|python)\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    for language, code in blocks:
        program = ["bash", "-ec"] if language == "sh" else [sys.executable, "-c"]
        subprocess.run([*program, code], cwd=folder, env=environment, check=True)


def main():
    """Run the page, and put its pictures side by side."""
    PICTURES.mkdir(exist_ok=True)
    with TemporaryDirectory() as folder:
        run_page(folder)
        images = {file.stem: imread(file) for file in Path(folder).glob("*.png")}
    images["pebbles"][images["holes"] > 0] = 255
    for sheet, names in SHEETS.items():
        beside = np.concatenate([images[name] for name in names], axis=1)
        imsave(PICTURES / f"{sheet}.webp", beside, check_contrast=False)
    middle = images["texture"][38:218, 131:381]
    imsave(ROOT / "docs" / "pictures" / "texture.webp", middle, check_contrast=False)


if __name__ == "__main__":
    main()
