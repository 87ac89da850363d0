"""The pictures of README: ``python -m docs.readme_pictures``."""

from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from PIL import Image
from skimage.io import imsave

from eval.pages.figures import contact_sheet
from stylit_ref import Params, read_uint8, stylize
from stylit_ref.cli import main

BUNDLED = Path("data_gen/bundled")
PICTURES = Path(__file__).with_name("pictures")
GUIDES = "FULL", "LDE", "LSE", "LDDE", "LD12E", "IDMASK"
TARGETS = "stego", "teapot", "helmet", "scorpion"
STYLES = "crayon", "oil", "pen"


def painting(style):
    """What was painted over the source."""
    return read_uint8(BUNDLED / f"source/styles/{style}.png")


def stylized(target, style, **params):
    """A target in a style, with its objects told apart."""
    passes = [
        [read_uint8(BUNDLED / scene / f"{name}.png") for name in GUIDES]
        for scene in ("source", target)
    ]
    return stylize(painting(style), *passes, Params(**params))


def save_small(image, name):
    """Save the middle of an image, for a table."""
    imsave(PICTURES / f"{name}.webp", image[35:215, 40:290], check_contrast=False)


def save_thumbnail(picture, name):
    """Save a picture made small, for a table."""
    picture.thumbnail((250, 180))
    picture.save(PICTURES / f"{name}_small.webp")


def moving_house():
    """The first and the last of three coherent frames, side by side."""
    with TemporaryDirectory() as folder:
        code = main([
            "sequence", "--preset", "fast", "--style", f"{BUNDLED}/source/styles/watercolour.png",
            "--guide", f"{BUNDLED}/source", f"{BUNDLED}/house/1_%d",
            "--guide-layers", "FULL,LDE,IDMASK", "--ids", f"{BUNDLED}/house/1_%d/IDMASK.png",
            "--motion", f"{BUNDLED}/house/motion/1_%d_to_1_%d.exr", "--output", f"{folder}/%d.png",
        ])  # fmt: skip
        assert code == 0
        return Image.fromarray(np.hstack([read_uint8(f"{folder}/{k}.png") for k in (0, 2)]))


rendered = [(name, read_uint8(BUNDLED / name / "FULL.png")) for name in ("source", *TARGETS)]
painted = [
    [(style, painting(style)), *(("", stylized(target, style).image) for target in TARGETS)]
    for style in STYLES
]
contact_sheet([rendered, *painted], PICTURES / "stylized.webp", tile=240)
save_small(stylized("teapot", "oil").image, "occurrence_map")
guide_map = stylized("teapot", "oil", method="guide_map").guide_maps[-1]
save_small(guide_map.astype("uint8") * 255, "guide_map")
save_small(stylized("teapot", "crayon", method="stylit").image, "stylit")
save_thumbnail(moving_house(), "sequence")
studio = Image.open(PICTURES / "studio.webp").convert("RGB")
save_thumbnail(studio.crop((46, 123, 692, 436)), "studio")
