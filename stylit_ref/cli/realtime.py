"""``stylit-ref run --method realtime``: one frame, cold or warm."""

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from time import perf_counter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.deep_images import read_deep_images
from stylit_ref.cli.finished import tell_finished
from stylit_ref.cli.guide_options import guide_files
from stylit_ref.cli.images_in import paths_in, read_images
from stylit_ref.cli.progress_line import ProgressLine
from stylit_ref.cli.realtime_buffers import buffers_of_files, weights_of
from stylit_ref.errors import InputError
from stylit_ref.files.colour.profile import read_colour_profile
from stylit_ref.files.disk.paths import check_distinct
from stylit_ref.files.nnf_file import check_nnf_writable
from stylit_ref.files.realtime_field import RealtimeField, read_any_field, write_realtime_field
from stylit_ref.files.write_image import check_image_writable, write_image
from stylit_ref.machine.compilation import Specialization
from stylit_ref.machine.profiling import Profile
from stylit_ref.notes import note
from stylit_ref.realtime.checks import check_sides
from stylit_ref.realtime.packing import (
    Packing,
    StagePacking,
    UnpackedStage,
    choose_packing,
    pack,
)
from stylit_ref.realtime.packing.named_buffers import (
    NamedBuffers,
    find_unknown_thing,
    read_by,
)
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.realtime.replaying import replay_dense, replay_realtime
from stylit_ref.realtime.session import Session
from stylit_ref.realtime.warm_up import kernels_of_frame


class Frame(NamedTuple):
    """B' and its NNF; with ``dense_finish`` the NNF that it was averaged by, too."""

    image: NDArray[np.uint8]
    nnf: NDArray[np.int32]
    dense: NDArray[np.int32] | None


def run_realtime(options: argparse.Namespace, params: RealtimeParams) -> None:
    """Read, pack, compute a frame, write; all is checked before the work starts."""
    start, profile = perf_counter(), Profile()
    with profile.stage("reading images"):
        images = read_images(options)
        style = _in_colour(options.style, images.style)
        files = guide_files(options)
        buffers = buffers_of_files(files, images)
        before = _field_before(options.warm_start, params, style, images.target_guides[0])
    check_image_writable(options.output, images.style.shape[2])
    if options.nnf:
        check_nnf_writable(options.nnf)
    check_distinct([options.output, options.nnf], [*paths_in(options), options.warm_start])
    colours = read_colour_profile(options.style)
    deep = read_deep_images(options, images.deep_style, images.style.shape[2])
    packing = choose_packing(buffers.source, params.packing)
    _tell_unread(packing, buffers)
    weights = weights_of(options, packing, buffers)
    with ProgressLine(options.quiet) as line:
        line.compile(lambda: kernels_of_frame(params, packing))
        with profile.stage("packing and search"):
            frame = realtime_frame(
                style, buffers, packing, params, [target for _, target in files],
                weights=weights, before=before, seed=options.seed, threads=options.threads,
            )  # fmt: skip
    field = RealtimeField(
        frame.nnf, params.patch_width, params.step, style.shape[:2],
        images.target_guides[0].shape[:2], images.guide_encodings,
    )  # fmt: skip
    image = frame.image
    if deep or images.style.shape != style.shape:
        image = _through(frame, field, deep.style if deep else images.style)
    if options.nnf and frame.dense is not None:
        note("keeps the matches before --dense-finish, by which replay averages", parameter="nnf")
    with profile.stage("writing images"):
        write_image(options.output, image, profile=colours)
        if options.nnf:
            write_realtime_field(options.nnf, field)
    if options.profile:
        print(*profile.table(), sep="\n", file=sys.stderr)
    if not options.quiet:
        others = filter(None, (options.nnf,))
        tell_finished(options.output, image, perf_counter() - start, *others)


def realtime_frame(
    style: NDArray[np.uint8],
    buffers: NamedBuffers,
    packing: Packing,
    params: RealtimeParams,
    files: Sequence[str],
    *,
    weights: Sequence[int] | None = None,
    before: RealtimeField | None = None,
    seed: int = 0,
    threads: int | None = None,
) -> Frame:
    """A frame by a session of its own.

    Parameters
    ----------
    style : (H_A, W_A, 3) uint8
    buffers : NamedBuffers
    packing : Packing
    params : RealtimeParams
    files : sequence of str
        The target's, of every guide, for a refusal.
    weights : sequence of int, optional
        One for each channel of the packing.
    before : RealtimeField, optional
        The frame that a warm one starts from.
    seed : int
    threads : int, optional

    Raises
    ------
    InputError
        If the target has what the source lacks.
    """
    source, labels = pack(packing, read_by(packing, buffers.source))
    target, target_labels = pack(packing, read_by(packing, buffers.target))
    if params.labels:
        _check_labels(labels, target_labels, packing, buffers, files)
    session = Session(params, seed=seed, threads=threads)
    session.set_exemplar(source, style, labels)
    session.set_target(target, target_labels)
    session.set_weights(weights)
    if before:
        session.nnf = before.nnf
    image = session.frame(warm=before is not None)
    return Frame(image, session.nnf, session.dense_nnf() if params.dense_finish else None)


def _through(
    frame: Frame, field: RealtimeField, style: NDArray[np.uint8 | np.uint16 | np.float32]
) -> NDArray[np.uint8 | np.uint16 | np.float32]:
    """The frame in other colours, or at another bit depth."""
    if frame.dense is None:
        return replay_realtime(field, style)
    return replay_dense(frame.dense, style, field.patch_width)


def kernels_of_realtime(
    params: RealtimeParams, style_channels: int, guide_channels: Sequence[int]
) -> list[Specialization]:
    """As :func:`stylit_ref.stylization.warm_up.kernels_of_run`: of both packings where it is open.

    The style has three channels when the search reads it, whatever its file has.
    """
    black = {f"guide {k}": np.zeros((2, 2, min(n, 3)), np.uint8)
             for k, n in enumerate(guide_channels)}  # fmt: skip
    black["IDMASK"] = np.zeros((2, 2, 3), np.uint8)
    packings = {"packed": StagePacking(), "all": UnpackedStage()}
    if params.packing in ("pca", "auto"):
        packings["pca"] = choose_packing(black, "pca")
    names = ("packed", "pca") if params.packing == "auto" else (params.packing,)
    kernels = [kernel for name in names for kernel in kernels_of_frame(params, packings[name])]
    return list(dict.fromkeys(kernels))


def _in_colour(path: str, style: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """What the search compares of a style: its colours, over black where it is transparent."""
    check_sides(style.shape[:2], f"--style {path}")
    colours = style if style.shape[2] in (1, 3) else style[:, :, :-1]
    return np.ascontiguousarray(np.broadcast_to(colours, (*style.shape[:2], 3)))


def _field_before(
    path: str | None, params: RealtimeParams, style: NDArray[np.uint8], target: NDArray[np.uint8]
) -> RealtimeField | None:
    """What ``--warm-start`` names, if it fits the run."""
    check_sides(target.shape[:2], "the target")
    if path is None:
        return None
    field = read_any_field(path)
    if not isinstance(field, RealtimeField):
        is_bare = field.patch_width is None
        why = "does not say which run it is of" if is_bare else "is of a run of another method"
        raise InputError(
            f"{path}: {why}; name what --method realtime wrote with --nnf, as it was written",
            parameter="warm_start",
        )
    was = field.patch_width, field.spacing, tuple(field.style_size), tuple(field.target_size)
    now = params.patch_width, params.step, style.shape[:2], target.shape[:2]
    for name, before, this in zip(
        ("patches of width", "a grid with the spacing", "a style of", "a target of"),
        map(_told, was), map(_told, now), strict=True,
    ):  # fmt: skip
        if before != this:
            raise InputError(
                f"{path}: is of a run with {name} {before}, and this one has {this}; make them "
                "the same, or leave it out",
                parameter="warm_start",
            )
    return field


def _told(value):
    return f"{value[1]}x{value[0]}" if isinstance(value, tuple) else str(value)


def _tell_unread(packing: Packing, buffers: NamedBuffers) -> None:
    unread = [name for name in buffers.source if name not in packing.names]
    if unread:
        note(f"has no use for {', '.join(unread)}; pca reads all guides", parameter="packing")


def _check_labels(
    source: NDArray[np.uint8],
    target: NDArray[np.uint8],
    packing: Packing,
    buffers: NamedBuffers,
    files: Sequence[str],
) -> None:
    """Refuse a thing in the target that the source does not show."""
    thing = find_unknown_thing(source, target, packing, buffers.target)
    if thing:
        colour = ", ".join(map(str, thing.colour))
        name = Path(files[buffers.guide_of[thing.buffer]]).as_posix()
        raise InputError(
            f"{name}: the pixel at x {thing.x}, y {thing.y}, of the colour {colour}, belongs to a "
            "thing that the source does not show; add it there, or let paint go anywhere with "
            "--labels no"
        )
