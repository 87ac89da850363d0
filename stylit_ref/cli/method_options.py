"""Options of ``run`` that shape the result, and the parameters that they give."""

from argparse import ArgumentTypeError
from dataclasses import fields

from stylit_ref.cli.methods import OFFERS, offer_of
from stylit_ref.errors import InputError

SPELLED = {
    "patch_width": "--patch-size",
    "levels": "--pyramid-levels",
    "votes": "--search-vote-iters",
    "patchmatch_iterations": "--patchmatch-iters",
}
"""Options that are not spelled as their parameters: users of ebsynth and StyLit know them so."""

_OTHERS = "method", "guide_weights"
"""Parameters whose options are made by hand: ``--weight`` stands beside its guide."""


def add_method_options(parser):
    """Add ``--method`` and an option for every parameter, None where it is not given."""
    method = parser.add_argument_group("method (defaults of the thesis)")
    texts = "; ".join(f"{name}, {offer.text}" for name, offer in OFFERS.items())
    method.add_argument(
        "--method", default=next(iter(OFFERS)), help=f"{texts} (default %(default)s)"
    )
    for each in _parameters():
        method.add_argument(
            SPELLED.get(each.name, f"--{each.name.replace('_', '-')}"),
            dest=each.name,
            type=_parsed(each.metadata["kind"]),
            help=f"{each.metadata['text']} "
            f"(default {'none' if each.default is None else each.default})",
        )
    presets = dict.fromkeys(name for offer in OFFERS.values() for name in offer.presets)
    method.add_argument(
        "--preset", choices=presets, default=next(iter(presets)),
        help="effort where the options above do not say: thesis, or fast, as for a preview "
        "(default %(default)s)",
    )  # fmt: skip
    method.add_argument(
        "--seed", type=int, default=0, help="same seed, same result (default %(default)s)"
    )


def _parameters():
    """Fields of the methods' parameter classes that have an option here, each name once."""
    classes = dict.fromkeys(offer.params for offer in OFFERS.values())
    named = {}
    for each in (each for params in classes for each in fields(params)):
        named.setdefault(each.name, each)
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
    offer = offer_of(options.method)
    given = {each.name: getattr(options, each.name) for each in _parameters()}
    chosen = {name: value for name, value in given.items() if value is not None}
    for name in chosen:
        if name not in offer.heeds:
            methods = [method for method, other in OFFERS.items() if name in other.heeds]
            raise InputError(
                f"is for --method {', '.join(methods)}; the method is {options.method}",
                parameter=name,
            )
    if options.preset not in offer.presets:
        raise InputError(
            f"is {options.preset}, which is not for method {options.method}", parameter="preset"
        )
    values = offer.presets[options.preset] | chosen | {"method": options.method}
    values["guide_weights"] = tuple(
        options.guide_weights.get(k, 1.0) for k in range(len(options.guide))
    )
    names = {each.name for each in fields(offer.params)}
    return offer.params(**{name: value for name, value in values.items() if name in names})
