"""What can be set: parameters of the live frames and of the dense method, as sliders need them."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from functools import cached_property
from typing import Any, Literal

from stylit_ref.errors import InputError, did_you_mean, shown
from stylit_ref.parameters import Choice, Flag, Integer, Number, Optional, Several
from stylit_ref.randomness.seed import check_seed
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.stylization.params import Params

DENSE = "uniformity", "guide_influence", "vote_outliers"
"""Parameters of the dense method alone. It takes its ``patch_width`` from the live frames."""

DENSE_PRESETS = {"fast": "fast", "full": "final"}
"""The preset of each picture that is made in the background."""

WEIGHT = Integer(0, 8)
"""Of a buffer; 1 by default, 0 leaves it out. Larger ones would overflow the live search."""

_SLIDER_ENDS = {"uniformity": 50000, "guide_influence": 20, "iterations": 32}
"""Where sliders end whose parameters go further than anyone needs."""


@dataclass(frozen=True)
class Field:
    """A parameter as a page shows it.

    Attributes
    ----------
    name : str
    kind : {"integer", "number", "choice", "flag", "several"}
        ``several`` is a list of integers by level, finest first, whose last goes for all above.
    least, most : float or None
        Ends of its slider; of ``several`` those of each.
    choices : tuple of str
    help : str
    of : {"live", "dense"}
        What it moves.
    is_odd : bool
        Whether it must be odd.
    is_optional : bool
        Whether it may be None.
    """

    name: str
    kind: Literal["integer", "number", "choice", "flag", "several"]
    least: float | None
    most: float | None
    choices: tuple[str, ...]
    help: str
    of: Literal["live", "dense"]
    is_odd: bool = False
    is_optional: bool = False


def _fields_of(params: type, of: Literal["live", "dense"]) -> list[Field]:
    return [
        _field(each.name, each.metadata["kind"], each.metadata["text"], of)
        for each in fields(params)
        if of == "live" or each.name in DENSE
    ]


def _field(name: str, kind: Any, text: str, of: Literal["live", "dense"]) -> Field:
    match kind:
        case Optional():
            return replace(_field(name, kind.kind, text, of), is_optional=True)
        case Several():
            return replace(_field(name, kind.kind, text, of), kind="several")
        case Choice():
            return Field(name, "choice", None, None, kind.names, text, of)
        case Flag():
            return Field(name, "flag", None, None, (), text, of)
        case Number() | Integer():
            most = min(kind.most, _SLIDER_ENDS.get(name, kind.most))
            name_of_kind = "number" if isinstance(kind, Number) else "integer"
            is_odd = isinstance(kind, Integer) and kind.odd
            return Field(name, name_of_kind, kind.least, most, (), text, of, is_odd)
    raise TypeError(f"{name} is of a kind that no page shows")


FIELDS = (*_fields_of(RealtimeParams, "live"), *_fields_of(Params, "dense"))
"""Every parameter, those of the live frames first."""


@dataclass(frozen=True)
class Settings:
    """All that shapes pictures beside the scene and the painting.

    Attributes
    ----------
    live : RealtimeParams
    dense : Params
        Of it only :data:`DENSE` counts.
    weights : mapping of str to int
        By buffer; 1 where there is none.
    seed : int
    """

    live: RealtimeParams = field(default_factory=RealtimeParams)
    dense: Params = field(default_factory=Params)
    weights: Mapping[str, int] = field(default_factory=dict)
    seed: int = 0

    def __post_init__(self) -> None:
        check_seed(self.seed)

    @property
    def values(self) -> dict[str, Any]:
        """Parameters by name."""
        return asdict(self.live) | {name: getattr(self.dense, name) for name in DENSE}

    @cached_property
    def of_live(self) -> "Settings":
        """What live frames depend on; the rest is as it is by default."""
        return replace(self, dense=Params())

    def with_parameters(self, values: Mapping[str, object]) -> "Settings":
        """Other values of some parameters.

        Raises
        ------
        InputError
            If there is no such parameter, or a value is out of range.
        """
        known = [each.name for each in FIELDS]
        for name in values:
            if name not in known:
                raise InputError(f"no parameter is called {shown(name)}{did_you_mean(name, known)}")
        live = {name: value for name, value in values.items() if name not in DENSE}
        dense = {name: value for name, value in values.items() if name in DENSE}
        changed = replace(self, live=replace(self.live, **live))
        width = changed.live.patch_width
        return replace(changed, dense=replace(self.dense, patch_width=width, **dense))

    def with_weights(self, values: Mapping[str, int], buffers: tuple[str, ...]) -> "Settings":
        """Other weights of some buffers.

        Raises
        ------
        InputError
            If there is no such buffer, or a weight is out of range.
        """
        weights = dict(self.weights)
        for name, weight in values.items():
            if name not in buffers:
                raise InputError(f"no buffer is called {shown(name)}{did_you_mean(name, buffers)}")
            weights[name] = WEIGHT.check(f"the weight of {name}", weight)
        return replace(self, weights=weights)

    def weights_of(self, buffers: tuple[str, ...]) -> tuple[int, ...]:
        """The weight of each of these buffers."""
        return tuple(self.weights.get(name, 1) for name in buffers)

    def dense_params(self, which: str, buffers: tuple[str, ...]) -> Params:
        """Parameters of a picture that is made in the background.

        Parameters
        ----------
        which : {"fast", "full"}
        buffers : tuple of str
            Those of the scene.
        """
        preset = Params.preset(DENSE_PRESETS[which])
        own = {name: getattr(self.dense, name) for name in (*DENSE, "patch_width")}
        weights = tuple(map(float, self.weights_of(buffers)))
        return replace(preset, **own, guide_weights=weights)
