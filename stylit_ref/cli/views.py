"""``stylit-ref views``: stylize a grid of views so that strokes stay where they are."""

import argparse
from collections.abc import Sequence
from dataclasses import replace

from stylit_ref.cli.motion_files import VectorsOfPairs, vectors_of_pairs
from stylit_ref.cli.parser import Parser
from stylit_ref.cli.scene_files import SceneFiles
from stylit_ref.cli.shot_in import ShotFiles
from stylit_ref.cli.shot_options import (
    add_other_outputs,
    add_shot_options,
    chosen_coherence,
    shot_params,
)
from stylit_ref.cli.shot_problems import ShotProblems
from stylit_ref.cli.stylize_shot import stylize_shot
from stylit_ref.cli.views_manifest import OTHER, VIEW, Manifest, read_manifest
from stylit_ref.errors import InputError
from stylit_ref.views.params import Coherence

_USAGE = "%(prog)s --manifest FILE.json --output '{view}.png' [options]"

_DESCRIPTION = """\
Stylize views of a scene from all sides, so that strokes stay where they are from one view to the
next. A manifest names the files: the painting, the guides of the source and of every view, which
views are neighbours, and the motion from each into the other. For instance:

  stylit-ref views --preset fast --manifest house.json --output 'out/{view}.png'

docs/how_to/sequences.md describes the manifest. Without motion every view is stylized by itself."""

_ALONE = "each view is stylized by itself; name the motion in the manifest, and strokes stay"


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "views",
        help="stylize a grid of views so that strokes stay where they are",
        usage=_USAGE,
        description=_DESCRIPTION,
    )
    parser.set_defaults(command=run, parser=parser)
    everyday = parser.add_argument_group("everyday options")
    everyday.add_argument(
        "--manifest", required=True, metavar="FILE.json", help="what the views are made of"
    )
    everyday.add_argument(
        "--output", required=True, metavar="IMAGE",
        help="the pictures to write, with {view} where the name of the view stands",
    )  # fmt: skip
    everyday.add_argument("--style", metavar="IMAGE", help="another painting than the manifest's")
    add_shot_options(parser, everyday, Coherence())
    add_other_outputs(parser, "FILE.npy", "'{view}.npy'")


def run(options: argparse.Namespace) -> None:
    """Find the files of all views, and stylize them."""
    manifest = read_manifest(options.manifest)
    params = replace(shot_params(options), guide_weights=manifest.weights)
    default = Coherence() if manifest.motion else None
    coherence = chosen_coherence(options, default, "motion in the manifest")
    guides = [[guide.replace(VIEW, view) for guide in manifest.guides] for view in manifest.views]
    motion = _motion(manifest)
    style = options.style or manifest.style
    problems = ShotProblems()
    paths = [style, *manifest.source_guides, *(path for side in guides for path in side)]
    paths += [path for vectors in motion.values() for path in vectors.files]
    scene = SceneFiles(
        manifest.mesh,
        _of_views(manifest.positions, manifest.views),
        _of_views(manifest.ids, manifest.views),
    )
    paths += scene.files
    problems.add_missing(paths)
    problems.refuse()
    for files_of_view in guides:
        problems.patterns |= zip(files_of_view, manifest.guides, strict=True)
    problems.know(motion.values(), manifest.motion, manifest.depth, manifest.ids)
    files = ShotFiles(
        [style], [manifest.source_guides], manifest.views, guides, motion, problems,
        grid=manifest.grid, cameras=manifest.cameras, scene=scene,
    )  # fmt: skip
    pictures, fields = (
        _outputs(text, name, manifest.views) if text else []
        for name, text in (("output", options.output), ("nnf", options.nnf))
    )
    stylize_shot(options, files, params, coherence, pictures, fields, _ALONE)


def _motion(manifest: Manifest) -> dict[tuple[int, int], VectorsOfPairs]:
    if manifest.motion is None:
        return {}
    views, motion = manifest.views, manifest.motion
    beside = [dict(enumerate(_of_views(each, views))) for each in (manifest.depth, manifest.ids)]
    return vectors_of_pairs(
        {pair: pair for pair in manifest.pairs},
        lambda to, other: motion.replace(VIEW, views[to]).replace(OTHER, views[other]),
        manifest.motion_convention,
        *beside,
    )


def _of_views(text: str | None, views: Sequence[str]) -> list[str]:
    """The file of every view; none if no file is named."""
    return [text.replace(VIEW, view) for view in views] if text else []


def _outputs(text: str, parameter: str, views: Sequence[str]) -> list[str]:
    if VIEW not in text:
        raise InputError(
            f"{text}: names one file; write {VIEW} where the name of the view stands",
            parameter=parameter,
        )
    return [text.replace(VIEW, view) for view in views]
