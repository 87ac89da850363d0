"""Options of ``run`` that shape the result, and the parameters that they give."""

from argparse import ArgumentTypeError

from stylit_ref.cli.methods import offer_of
from stylit_ref.errors import InputError
from stylit_ref.stylization.params import HEEDED_BY, PRESETS, Params


def add_method_options(parser):
    """Add the options; those of the table are None where they are not given."""
    method = parser.add_argument_group("method (defaults of the thesis)")
    defaults = Params()
    for name, (flag, kind, text) in _METHOD.items():
        default = getattr(defaults, name)
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


def chosen_params(options):
    """Parameters of the method that was chosen.

    Parameters
    ----------
    options : argparse.Namespace
        Of :func:`add_method_options`, and ``guide``, ``guide_weights``.

    Returns
    -------
    Params
        Or the dataclass of another method.

    Raises
    ------
    InputError
        If a value is out of range, or for another method.
    """
    chosen = {name: getattr(options, name) for name in _METHOD}
    chosen = {name: value for name, value in chosen.items() if value is not None}
    weights = tuple(options.guide_weights.get(k, 1.0) for k in range(len(options.guide)))
    offer = offer_of(chosen.get("method", Params().method))
    params = offer.params(**(PRESETS[options.preset] | chosen), guide_weights=weights)
    for name, methods in HEEDED_BY.items():
        if name in chosen and params.method not in methods:
            raise InputError(
                f"is for --method {', '.join(methods)}; the method is {params.method}",
                parameter=name,
            )
    return params


def _votes(text):
    try:
        votes = tuple(int(number) for number in text.split(","))
    except ValueError:
        raise ArgumentTypeError(
            f"{text!r} is neither an integer nor integers separated by commas"
        ) from None
    return votes if len(votes) > 1 else votes[0]


def _budget(text):
    if text == "hyperbola":
        return text
    try:
        return float(text)
    except ValueError:
        raise ArgumentTypeError(f"{text!r} is neither hyperbola nor a number") from None


_METHOD = {
    "method": (
        "--method",
        str,
        "ref, as in the thesis; shared_memory, the same for a GPU; guide_map, its approximation; "
        "or stylit, by an error budget",
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
        "propose_commit (parallel) or scanline (sequential); on a GPU also live or live_sums, "
        "where Ω changes meanwhile, as in the thesis",
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
