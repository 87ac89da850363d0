"""Check Blender's vectors, and stylize its shot; make blender renders it first.

The vectors must lie within 0.05 pixels of projected points, the check of motion must name them and
refuse those of motion blur and of a moving orthographic camera, and the command for sequences must
make the shot coherent.
"""

from pathlib import Path

import numpy as np
from scipy.ndimage import gaussian_filter, maximum_filter

from eval.projection import vectors_off
from stylit_ref import InputError, read_uint8, write_image
from stylit_ref.cli import main as command_line
from stylit_ref.files.picture import read_picture
from stylit_ref.views.motion.places import fetched, places_in_other
from stylit_ref.views.motion.reading import read_motion
from stylit_ref.views.motion.visibility import cancelling

WITHIN = 0.05
"""How far vectors may lie from projected points, in pixels."""

GUIDES = ("Diffuse Direct", "Combined", "Object Index")


def add_options(parser):
    """Add the options of the report."""
    parser.add_argument(
        "--folder",
        type=Path,
        default=Path("build/blender"),
        help="what data_gen/blender_shot.py wrote (default build/blender)",
    )


def main(options):
    """Check and stylize; returns the exit code."""
    folder = options.folder
    inside, beside = vectors_off(folder)
    off = np.count_nonzero(beside > WITHIN)
    print(
        f"vectors: at most {inside.max():.4f} pixels from projected points; {off} of "
        f"{len(inside) + len(beside)} mix two objects at an outline"
    )
    if inside.max() > WITHIN:
        raise InputError(f"{folder}: vectors lie {inside.max():.2f} pixels from projected points")
    for shot, code in (("perspective", 0), ("blurred", 2), ("orthographic", 2)):
        print(f"\n{shot}:", flush=True)
        pictures = f"{folder}/{shot}/shot.%04d.exr:ViewLayer.Combined"
        vectors = f"{folder}/{shot}/shot.%04d.exr"
        if command_line(["motion", "check", "--guide", pictures, "--motion", vectors]) != code:
            raise InputError(f"{vectors}: the check of motion should end with code {code}")
    _paint(folder)
    for name, more in (("coherent", ["--motion", f"{folder}/perspective/shot.%04d.exr",
                                     "--depth", f"{folder}/perspective/shot.%04d.exr:Depth"]),
                       ("alone", [])):  # fmt: skip
        if command_line(_sequence(folder, name, more)):
            return 2
        print(f"{name}: warping error {_warping_error(folder, name):.2f}", flush=True)
    return 0


def _sequence(folder, name, more):
    """The words of ``stylit-ref sequence``."""
    words = ["sequence", "--style", f"{folder}/style.png", "--preset", "fast"]
    for layer in GUIDES:
        source, target = (
            f"{folder}/{of}.exr:{layer}" for of in ("source", "perspective/shot.%04d")
        )
        words += ["--guide", source, target]
    return [*words, *more, "--output", f"{folder}/{name}/%04d.png"]


def _paint(folder):
    """A style over the source: flat tones, streaks, and an outline that leaves the geometry."""
    source = f"{folder}/source.exr"
    shown = read_uint8(f"{source}:Combined")[:, :, :3].astype(float)
    ids = read_picture(f"{source}:Object Index", is_guide=True).pixels[:, :, 0]
    light = read_uint8(f"{source}:Diffuse Direct").mean(axis=2)
    rng = np.random.default_rng(0)
    streaks = gaussian_filter(rng.normal(size=ids.shape), (0.7, 4))
    tones = np.floor((light + 60 * streaks) / 64) / 4
    painted = np.empty_like(shown)
    for index in np.unique(ids):
        inside = ids == index
        painted[inside] = shown[inside].mean(axis=0) * (0.6 + 0.7 * tones[inside][:, None])
    painted += 40 * streaks[:, :, None]
    rims = (ids != np.roll(ids, 1, 0)) | (ids != np.roll(ids, 1, 1))
    rims[0] = rims[:, 0] = False
    painted[np.roll(maximum_filter(rims, 2), (-1, 1), (0, 1))] = 25
    write_image(f"{folder}/style.png", np.clip(painted, 0, 255).astype(np.uint8))


def _warping_error(folder, name):
    """Mean difference along the motion to the next frame, where it cancels with that back."""
    files = sorted((folder / "perspective").glob("shot.*.exr"))
    pictures = [read_uint8(folder / name / f"{file.suffixes[0][1:]}.png") for file in files]
    motions = [read_motion(file) for file in files]
    errors = []
    for k in range(len(files) - 1):
        ahead = motions[k].forward
        places = places_in_other(ahead)
        shown = cancelling(ahead, motions[k + 1].backward)
        here, there = pictures[k].astype(float), fetched(pictures[k + 1], places)
        errors.append(np.abs(here - there)[shown].mean())
    return np.mean(errors)
