"""``stylit-ref``: stylize images from the command line."""

import argparse
import sys
import warnings
from importlib import import_module
from itertools import chain
from pathlib import Path

import numpy as np
from tqdm import tqdm

from stylit_ref import __version__
from stylit_ref.cli.example import write_example
from stylit_ref.errors import InputError, one_line
from stylit_ref.files.image_io import (
    check_image_writable,
    read_guides,
    read_image,
    read_uint8,
    write_image,
)
from stylit_ref.files.output_file import (
    check_distinct,
    check_folder,
    check_regular,
    check_writable,
    real_path,
    whole_file,
)
from stylit_ref.machine.interruption import heed_interruptions
from stylit_ref.machine.profiling import Profile
from stylit_ref.machine.threads import sleep_while_waiting
from stylit_ref.stylization.backends import BACKENDS, cuda_report
from stylit_ref.stylization.checks import FewerLevelsWarning, check_guides, check_mask
from stylit_ref.stylization.methods import heeded_by
from stylit_ref.stylization.params import PRESETS, Params
from stylit_ref.stylization.replaying import replay
from stylit_ref.stylization.stylize import stylize

DEFAULTS = Params()


def command():
    """Entry point of ``stylit-ref``."""
    heed_interruptions()
    sleep_while_waiting()
    sys.exit(main())


def main(arguments=None):
    """Run the command line; returns the exit code.

    0 on success, 1 where a port differs from the oracle, 2 for input that cannot be used, 130 when
    interrupted.
    """
    options = _parser().parse_args(arguments)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("always", UserWarning)
            warnings.showwarning = _note
            return options.command(options) or 0
    except InputError as error:
        name = _FLAGS.get(error.parameter, error.parameter)  # it goes by its flag here
        print("stylit-ref:", *filter(None, [name, error.sentence]), file=sys.stderr)
        return 2
    except MemoryError:
        print("stylit-ref: there is not enough memory for images of this size", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("stylit-ref: interrupted; no half-written file is left", file=sys.stderr)
        return 130


def _note(message, *_):
    print(f"note: {one_line(str(message))}", file=sys.stderr)


class _Parser(argparse.ArgumentParser):
    """Refuses in one sentence, as everything else does."""

    def error(self, message):
        self.exit(2, f"{self.prog}: {one_line(message)} (--help shows the options)\n")


def _votes(text):
    votes = tuple(int(number) for number in text.split(","))
    return votes if len(votes) > 1 else votes[0]


_votes.__name__ = "integer, or integers separated by commas,"  # argparse puts it into its refusal


def _budget(text):
    return text if text == "hyperbola" else float(text)


_budget.__name__ = "budget (hyperbola or a number)"


_METHOD = {
    "method": (
        "--method",
        str,
        "ref, as in the thesis; guide_map, its approximation; or stylit, by an error budget",
    ),
    "uniformity": ("--uniformity", float, "λ, how evenly the style is used"),
    "guide_influence": ("--guide-influence", float, "μ, weight of the guides"),
    "patch_width": ("--patch-size", int, "patch width in pixels, odd"),
    "levels": ("--pyramid-levels", int, "levels of the pyramid"),
    "votes": (
        "--search-vote-iters",
        _votes,
        "search-vote iterations a level; 1,2,4 gives them from the finest level on",
    ),
    "patchmatch_iterations": ("--patchmatch-iters", int, "PatchMatch iterations a vote"),
    "schedule": (
        "--schedule",
        str,
        "propose_commit (parallel) or scanline (sequential)",
    ),
    "vote_outliers": ("--vote-outliers", int, "votes farthest from the mean that do not count"),
    "epsilon": (
        "--epsilon",
        float,
        "guide_map: ε, variance of the guides below which means stand for them",
    ),
    "budget": (
        "--budget",
        _budget,
        "stylit: hyperbola, for the knee of the sorted errors, or a share of their sum, as 0.9",
    ),
    "fixed_share": (
        "--fixed-share",
        float,
        "stylit: share of the target to be fixed by source-to-target retrieval",
    ),
    "error_limit": (
        "--error-limit",
        float,
        "stylit: α, most error of a fixed patch over the least that was found for it",
    ),
}


_FLAGS = {name: flag for name, (flag, _, _) in _METHOD.items()} | {
    "backend": "--backend",
    "seed": "--seed",
    "threads": "--threads",
    "jobs": "--jobs",
    "timeout": "--timeout",
}


class _Weigh(argparse.Action):
    """``--weight`` belongs to the ``--guide`` before it."""

    def __call__(self, parser, options, value, option_string=None):
        if not options.guide:
            parser.error(f"{option_string} {value:g}: must follow the --guide it weighs")
        if len(options.guide) - 1 in options.weights:
            parser.error(f"{option_string} {value:g}: the --guide before it has a weight already")
        options.weights = {**options.weights, len(options.guide) - 1: value}


def _parser():
    parser = _Parser(
        prog="stylit-ref",
        description="Illumination-guided, example-based stylization of 3D renderings.",
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="version", version=f"stylit-ref {__version__}")
    commands = parser.add_subparsers(required=True, metavar="{run,replay,example,oracle,doctor}")

    run = commands.add_parser(
        "run",
        help="stylize a target as a style exemplar shows",
        description="Stylize a target as a style exemplar shows. Images may be PNG, TIFF, JPEG, "
        "EXR and others; FILE.exr:LAYER names a layer of a multilayer EXR.",
        allow_abbrev=False,
    )
    run.set_defaults(command=_run, weights={})
    files = run.add_argument_group("images")
    files.add_argument("--style", required=True, metavar="IMAGE", help="style exemplar")
    files.add_argument(
        "--guide", nargs=2, action="append", required=True, metavar=("SOURCE", "TARGET"),
        help="a render pass of the exemplar's scene and of the target; repeat for each",
    )  # fmt: skip
    files.add_argument(
        "--weight", type=float, action=_Weigh, metavar="W",
        help="weight of the guide before it among all guides (default 1)",
    )  # fmt: skip
    files.add_argument("--mask", metavar="IMAGE", help="target pixels to leave alone (white)")
    files.add_argument(
        "--fill", metavar="IMAGE", help="what masked pixels show (default: transparent)"
    )
    files.add_argument("--output", required=True, metavar="IMAGE", help="stylized image to write")
    files.add_argument("--nnf", metavar="FILE.npy", help="write the nearest-neighbour field")
    files.add_argument(
        "--save-levels",
        metavar="DIR",
        help="write the image of every level, 1 the coarsest; for guide_map also the maps",
    )

    method = run.add_argument_group("method (defaults of the thesis)")
    for name, (flag, kind, text) in _METHOD.items():
        default = getattr(DEFAULTS, name)
        default = "none" if default is None else default
        method.add_argument(flag, dest=name, type=kind, help=f"{text} (default {default})")
    method.add_argument(
        "--preset", choices=PRESETS, default="thesis",
        help="effort where the options above do not say: thesis, or fast, as for a preview "
        "(default %(default)s)",
    )  # fmt: skip
    method.add_argument(
        "--seed", type=int, default=0, help="same seed, same result (default %(default)s)"
    )
    run.add_argument(
        "--backend", choices=BACKENDS, default="cpu",
        help="cpu; cuda for a GPU, cuda:shared_memory, cuda:live or cuda:live_sums for one of the "
        "thesis' other ways; auto for a GPU if there is one (default %(default)s)",
    )  # fmt: skip
    run.add_argument("--threads", type=int, help="threads to use (default: all)")
    run.add_argument("--quiet", action="store_true", help="no progress bar")
    run.add_argument("--profile", action="store_true", help="print where the time went")

    again = commands.add_parser(
        "replay",
        help="send another style image through a saved nearest-neighbour field",
        description="Vote another style image of the same size, or an enlargement, through a "
        "nearest-neighbour field saved by 'run --nnf', at the image's own bit depth.",
        allow_abbrev=False,
    )
    again.set_defaults(command=_replay)
    again.add_argument("--nnf", required=True, metavar="FILE.npy", help="nearest-neighbour field")
    again.add_argument("--style", required=True, metavar="IMAGE", help="style image")
    again.add_argument("--output", required=True, metavar="IMAGE", help="image to write")
    again.add_argument(
        "--patch-size", type=int, default=DEFAULTS.patch_width, dest="patch_width",
        help="patch width of the run (default %(default)s)",
    )  # fmt: skip
    again.add_argument(
        "--scale", type=int, default=1, help="how many times larger the style is (default 1)"
    )

    example = commands.add_parser(
        "example",
        help="copy the bundled scenes and say how to stylize one",
        description="Copy the bundled scenes, seven targets, a house, and a sphere painted in four "
        "styles, into a new folder, and print a command that stylizes one.",
        allow_abbrev=False,
    )
    example.set_defaults(command=lambda options: print(write_example(options.folder)))
    example.add_argument("folder", metavar="FOLDER", help="new folder for them")

    oracle = commands.add_parser(
        "oracle",
        help="check a port of the algorithm against test vectors",
        description="Check a port of the algorithm against test vectors of every stage.",
        allow_abbrev=False,
    ).add_subparsers(required=True, metavar="check")
    check = oracle.add_parser(
        "check",
        help="name the first stage, pixel and value that differ",
        description="Run a port on the cases and name the first stage, pixel and value that "
        "differ. Without one, this library's own passes are checked.",
        allow_abbrev=False,
    )
    check.set_defaults(command=_check_port)
    check.add_argument(
        "--port", metavar="COMMAND",
        help="runs the port on the case in folder {input}, its results go to folder {output}",
    )  # fmt: skip
    check.add_argument(
        "--module", metavar="NAME",
        help="Python module with run_case(stage, parameters, arrays), or with the passes",
    )  # fmt: skip
    check.add_argument(
        "--timeout", type=float, metavar="SECONDS",
        help="longest that a --port may take for a case (default 60)",
    )  # fmt: skip
    check.add_argument(
        "--jobs", type=int, default=1, metavar="N",
        help="processes that share the cases (default %(default)s)",
    )  # fmt: skip
    check.add_argument("--stages", metavar="A,B", help="stages to check (default: all)")
    check.add_argument(
        "--xfail", metavar="FILE", help="cases that must fail, a line each; * stands for anything"
    )
    check.add_argument("--json", metavar="FILE", help="write what became of every case")
    check.add_argument("--cases", metavar="v1", help="version of the cases (default: the newest)")

    doctor = commands.add_parser(
        "doctor",
        help="say what there is for a GPU",
        description="Say what of a GPU's software is installed, and what is missing.",
        allow_abbrev=False,
    )
    doctor.set_defaults(command=lambda _: print(*cuda_report(), sep="\n"))
    return parser


def _check_port(options):
    """The library knows no oracle: it is imported where it is asked for."""
    return import_module("oracle.command").check_port(options)


def _run(options):
    weights = tuple(options.weights.get(k, 1.0) for k in range(len(options.guide)))
    chosen = {
        name: getattr(options, name) for name in _METHOD if getattr(options, name) is not None
    }
    params = Params(**(PRESETS[options.preset] | chosen), guide_weights=weights)
    if "levels" not in chosen:  # who did not ask for levels need not hear that there are fewer
        warnings.simplefilter("ignore", FewerLevelsWarning)
    for name in chosen:
        methods = heeded_by(name)
        if methods and params.method not in methods:
            raise InputError(
                f"{_METHOD[name][0]} is for --method {', '.join(methods)}; "
                f"the method is {params.method}"
            )
    profile = Profile()
    with profile.stage("reading images"):
        style = read_uint8(options.style)
        source_guides, target_guides = zip(
            *(read_guides(source, target) for source, target in options.guide), strict=True
        )
    check_guides(style, source_guides, target_guides, *zip(*options.guide, strict=True))
    mask = fill = None
    if options.mask:
        mask = read_uint8(options.mask).mean(axis=2) >= 128
    if options.fill:
        if not options.mask:
            raise InputError("--fill needs a --mask that says which pixels to fill")
        fill = read_uint8(options.fill)
    if options.mask:
        check_mask(
            mask, fill, target_guides[0].shape[:2], style.shape[2], options.mask, options.fill
        )

    transparent = mask is not None and fill is None and style.shape[2] % 2
    check_image_writable(options.output, style.shape[2] + bool(transparent))
    if options.nnf:
        _check_npy(options.nnf)
    levels = Path(options.save_levels) if options.save_levels else None
    if levels:
        check_folder(levels)
    check_distinct(
        [options.output, options.nnf, options.save_levels, *_level_files(levels, params)],
        [options.style, options.mask, options.fill, *chain.from_iterable(options.guide)],
    )
    if mask is not None and not mask.any():
        warnings.warn(f"{options.mask}: no pixel is white, so none is left alone", stacklevel=2)

    def save_level(level, image):
        if levels:
            levels.mkdir(parents=True, exist_ok=True)
            write_image(levels / _LEVEL.format(level), image)

    with tqdm(total=1.0, disable=options.quiet or None, bar_format=_BAR, file=sys.stderr) as bar:

        def show(step):
            energy = f"δ {step.delta:.0f}"
            if step.fixed is None:
                phi = step.delta + step.penalization
                energy = f"φ {phi:.0f} = {energy} + λρ {step.penalization:.0f}"
            else:
                energy += f"  retrieval {step.retrieval}: {step.fixed:.0%} fixed"
            bar.set_description_str(f"level {step.level}/{step.levels}  {energy}", refresh=False)
            bar.update(step.done - bar.n)

        result = stylize(
            style,
            source_guides,
            target_guides,
            params,
            seed=options.seed,
            mask=mask,
            fill=fill,
            backend=options.backend,
            threads=options.threads,
            progress=show,
            on_level=save_level,
            profile=profile,
        )
    with profile.stage("writing images"):
        write_image(options.output, result.image)
        for level, white in enumerate(result.guide_maps if levels else (), 1):
            image = white[:, :, None].astype(np.uint8) * 255
            write_image(levels / _GUIDE_MAP.format(level), image)
        if options.nnf:
            _save_npy(options.nnf, result.nnf)
    if options.profile:
        print(*profile.table(), sep="\n", file=sys.stderr)


def _replay(options):
    style = read_image(options.style)
    check_regular(real_path(options.nnf))
    try:
        # Mapped first: the file is as long as its header says, before memory is taken.
        nnf = np.array(np.lib.format.open_memmap(options.nnf, mode="r"), order="C")
    except OSError as error:
        raise InputError(f"{options.nnf}: cannot be read: {error.strerror}") from None
    except Exception as error:  # whatever the text of a header brings NumPy's parser to
        raise InputError(f"{options.nnf}: is not a readable .npy file: {error}") from None
    check_distinct([options.output], [options.style, options.nnf])
    check_image_writable(options.output, style.shape[2])
    image = replay(nnf, style, patch_width=options.patch_width, scale=options.scale)
    write_image(options.output, image)


_LEVEL, _GUIDE_MAP = "level_{}.png", "guide_map_{}.png"


def _level_files(folder, params):
    """What ``--save-levels`` may write."""
    if not folder:
        return []
    names = (_LEVEL, _GUIDE_MAP) if params.method == "guide_map" else (_LEVEL,)
    return [folder / name.format(k + 1) for name in names for k in range(params.levels)]


_BAR = "{percentage:3.0f}% |{bar}| {elapsed}<{remaining}  {desc}"


def _check_npy(path):
    if Path(path).suffix != ".npy":
        raise InputError(f"{path}: the nearest-neighbour field is written as .npy")
    check_writable(path)


def _save_npy(path, array):
    with whole_file(path, array.nbytes + 2**12) as partial:
        np.save(partial, array)
