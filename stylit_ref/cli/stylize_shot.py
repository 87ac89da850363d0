"""The work of ``sequence`` and ``views``: stylize a shot of files, and write its frames."""

import argparse
import sys
from collections.abc import Sequence
from dataclasses import replace
from time import perf_counter

from stylit_ref.cli.finished import counted_frames
from stylit_ref.cli.progress_line import ProgressLine
from stylit_ref.cli.shot_in import ShotFiles, read_shot
from stylit_ref.cli.shot_out import check_shot_outputs
from stylit_ref.files.colour.profile import read_colour_profile
from stylit_ref.files.disk.paths import check_folder
from stylit_ref.notes import note
from stylit_ref.stylization.params import Params
from stylit_ref.views.keyframes import weights_with_time
from stylit_ref.views.params import Coherence
from stylit_ref.views.problem import make_problem
from stylit_ref.views.run_writer import RunWriter
from stylit_ref.views.stylize_views import stylize_views
from stylit_ref.views.warm_up import kernels_of_frames
from stylit_ref.views.work.behind import Behind

_UNUSED = "--coherence is 0, so the motion is not used; with a larger number strokes move along"


def stylize_shot(
    options: argparse.Namespace,
    files: ShotFiles,
    params: Params,
    coherence: Coherence,
    pictures: Sequence[str],
    fields: Sequence[str],
    alone: str,
) -> None:
    """Read, stylize, write; all is checked before the work starts.

    Parameters
    ----------
    options : argparse.Namespace
    files : ShotFiles
    params : Params
    coherence : Coherence
    pictures, fields : sequences of str
        What is written of every frame; no fields where no NNF is.
    alone : str
        What is told where there is no motion, so that no frame heeds another.

    Raises
    ------
    InputError
        If anything does not fit together, or cannot be written.
    KeyboardInterrupt
        Its message says how to go on.
    """
    start = perf_counter()
    mesh = files.scene.read_mesh() if options.run else None
    done, advanced = 0, set()
    with ProgressLine(options.quiet) as line:

        def progress(step):
            advanced.add(step.frame)
            line.tell(step.done, _place(step))

        shot = read_shot(options, files, line)
        if files.times:
            of_files, keyframes = sum(shot.shot.channels), len(files.times.paintings)
            weights = weights_with_time(params.guide_weights, of_files, keyframes)
            params = replace(params, guide_weights=weights)
        outputs = check_shot_outputs(options, files, shot, params, pictures, fields)
        if options.work:
            check_folder(options.work)
        if not coherence.weight:
            note(alone if options.weight is None else _UNUSED)
        channels = shot.style.shape[2], tuple(guide.shape[2] for guide in shot.source_guides)
        line.compile(lambda: kernels_of_frames(params, coherence, *channels))
        writer = _run_writer(options, files, shot, params, coherence, mesh) if options.run else None

        def write(frame, writing):
            nonlocal done
            writing()
            done += 1
            line.wrote(pictures[frame], done, len(pictures))

        try:
            with Behind() as behind:
                for result in stylize_views(
                    shot.style, shot.source_guides, shot.shot, params, coherence,
                    seed=options.seed, threads=options.threads, work=options.work,
                    scheduler=options.scheduler, progress=progress,
                ):  # fmt: skip
                    behind.do(write, result.frame, outputs.writing(result))
                    if writer:
                        writer.add(result)
            if writer:
                writer.finish()
        except KeyboardInterrupt:
            raise KeyboardInterrupt(_how_to_go_on(options, done, len(pictures))) from None
    if not options.quiet:
        _tell_finished(pictures, shot, len(pictures) - len(advanced), perf_counter() - start)


def _run_writer(options, files, shot, params, coherence, mesh):
    return RunWriter(
        options.run,
        make_problem(
            shot.style, shot.source_guides, shot.shot, params, coherence, seed=options.seed
        ),
        encodings=shot.shot.encodings,
        grid=files.grid,
        cameras=files.cameras,
        profile=read_colour_profile(files.paintings[0]),
        mesh=mesh,
        positions=files.scene.read_positions if files.scene.positions else None,
    )


def _place(step):
    return (
        f"frame {step.frame + 1} of {step.frames}, level {step.level} of {step.levels}, "
        f"round {step.vote} of {step.votes}"
    )


def _how_to_go_on(options, done, count):
    written = f"{done} of {count} frames are written"
    if options.run:
        written += f", and {options.run} is no whole RUN yet"
    if options.work:
        return f"{written}; the same command goes on from {options.work}"
    return (
        f"{written}; nothing else is kept, so the same command begins anew; add --work FOLDER, and "
        "it goes on where it was interrupted"
    )


def _tell_finished(pictures, shot, found, seconds):
    height, width = shot.shot.size
    last = f" to {pictures[-1]}" if len(pictures) > 1 else ""
    were = "was" if found == 1 else "were"
    kept = f"; {found} of them {were} finished before" if found else ""
    print(
        f"wrote {counted_frames(len(pictures))}, {pictures[0]}{last} ({width}x{height}), in "
        f"{seconds:.1f} s{kept}",
        file=sys.stderr,
    )
