"""Options of ``run`` that shape the result, and the parameters that they give."""

from argparse import ArgumentTypeError
from dataclasses import fields

from stylit_ref.cli.methods import OFFERS, offer_of
from stylit_ref.errors import InputError
from stylit_ref.stylization.methods import heeded_by
from stylit_ref.stylization.params import PRESETS, Params

SPELLED = {
    "patch_width": "--patch-size",
    "levels": "--pyramid-levels",
    "votes": "--search-vote-iters",
    "patchmatch_iterations": "--patchmatch-iters",
}
"""Options that are not spelled as their parameters: users of ebsynth and StyLit know them so."""

_OTHERS = ("guide_weights",)  # --weight, beside its guide


def add_method_options(parser):
    """Add an option for every parameter of every method, None where it is not given."""
    method = parser.add_argument_group("method (defaults of the thesis)")
    for each in _parameters():
        method.add_argument(
            SPELLED.get(each.name, f"--{each.name.replace('_', '-')}"),
            dest=each.name,
            type=_parsed(each.metadata["kind"]),
            help=f"{each.metadata['text']} "
            f"(default {'none' if each.default is None else each.default})",
        )
    method.add_argument(
        "--preset", choices=PRESETS, default="thesis",
        help="effort where the options above do not say: thesis, or fast, as for a preview "
        "(default %(default)s)",
    )  # fmt: skip
    method.add_argument(
        "--seed", type=int, default=0, help="same seed, same result (default %(default)s)"
    )


def _parameters():
    """Fields of the methods' parameter classes that have an option here, each name once."""
    classes = dict.fromkeys(offer.params for offer in OFFERS.values())
    named = {each.name: each for params in classes for each in fields(params)}
    return [each for name, each in named.items() if name not in _OTHERS]


def _parsed(kind):
    def parse(text):
        try:
            return kind.parse(text)
        except ValueError:
            raise ArgumentTypeError(f"is {text!r}; it must be {kind.described}") from None

    return parse


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
    given = {each.name: getattr(options, each.name) for each in _parameters()}
    chosen = {name: value for name, value in given.items() if value is not None}
    weights = tuple(options.guide_weights.get(k, 1.0) for k in range(len(options.guide)))
    offer = offer_of(chosen.get("method", Params().method))
    params = offer.params(**(PRESETS[options.preset] | chosen), guide_weights=weights)
    for name in chosen:
        methods = heeded_by(name)
        if methods and params.method not in methods:
            raise InputError(
                f"is for --method {', '.join(methods)}; the method is {params.method}",
                parameter=name,
            )
    return params
