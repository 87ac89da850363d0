"""Parameters of stylization in real time."""

from dataclasses import dataclass, replace
from functools import partial
from typing import Any

from stylit_ref.errors import InputError
from stylit_ref.parameters import (
    Choice,
    Flag,
    Integer,
    Optional,
    Several,
    check_fields,
    parameter,
)
from stylit_ref.realtime.formulae.feature_distance import MU_ONE, TERMS

EVERYWHERE = 1 << 15
"""A radius that reaches the whole source at any level."""

MEANS = "mip", "box"
PACKINGS = "auto", "packed", "all", "pca"
STARTS = "vote", "bilinear"


@dataclass(frozen=True)
class RealtimeParams:
    """What shapes a picture, apart from the images, their weights and the seed (Heidrich 2017).

    What differs by level is a list from the finest level, 0, upwards; its last value goes for all
    levels above.

    Attributes
    ----------
    patch_width : int
        w, pixels along a patch.
    spacing : int, optional
        r, pixels from entry to entry of the sparse grid; ``(w + 1) / 2`` by default.
    levels : int
        L, levels of the pyramid.
    mu : tuple of int
        μ by level in sixteenths: the weight of the style, where ``1 - μ`` is that of the guides.
    terms : {"sums", "means"}
        Whether E sums over channels, as printed, or takes the mean of each term's.
    iterations : tuple of int
        Iterations by level: a search in two halves each, and a blend. Level 0 of a warm frame has
        ``warm_iterations``.
    radii : tuple of int
        Largest radius of the random search by level, in pixels of that level; 32768 for the whole
        source.
    start : {"vote", "bilinear"}
        What B' of a level is at first: blended from the upsampled NNF, or interpolated from B' of
        the level above (5.2.4).
    scale_space : bool
        Compare pixels at several scales (4.2.3) instead of patches.
    depth : int
        D, scales of that comparison.
    means : {"mip", "box"}
        What a scale is: a texel of a coarser level, or the mean of a centred box.
    unread_terms : bool
        Leave out the guides where μ = 1 (equation 22).
    renewal_level : int
        The level of a warm frame whose matches, searched from nothing, replace those of the last
        frame that have grown old; 0 for none.
    warm_mu : int
        μ at level 0 of a warm frame; in scale space that of ``mu``, which the records are made for.
        A search by style alone would hold on to matches that have grown old.
    warm_radius : int
        The largest radius of the random search at level 0 of a warm frame.
    warm_iterations : int
        Iterations at level 0 of a warm frame. The first searches every entry. Each later one
        searches only entries whose match moved in the one before, and their neighbours: what was
        renewed settles.
    dense_finish : bool
        Give every pixel the best match of the entries around it at the end, and average all patches
        over it: less energy, but slower. Not with ``scale_space``.
    labels : bool
        Whether a patch must have the label of the entry that it is for, where labels are given.
    packing : {"auto", "packed", "all", "pca"}
        How buffers become guides: the thesis' channels (figure 16), all of them, principal
        components, or what suits the buffers
        (:func:`~stylit_ref.realtime.packing.choose.choose_packing`).
    """

    patch_width: int = parameter(5, Integer(3, 13, odd=True), "w, pixels along a patch")
    spacing: int | None = parameter(
        None, Optional(Integer(2, 13)), "pixels between entries of the grid; none is (w + 1) / 2"
    )
    levels: int = parameter(6, Integer(1, 12), "levels of the pyramid")
    mu: tuple[int, ...] = parameter(
        (4, 4, 4, 4, 0), Several(Integer(0, MU_ONE), "mu of level"),
        "weight of the style in sixteenths by level, finest first; the rest is that of the guides",
    )  # fmt: skip
    terms: str = parameter(
        "sums", Choice(TERMS), "how channels count: as sums, or as the mean of each term"
    )
    iterations: tuple[int, ...] = parameter(
        (1, 4, 6, 8), Several(Integer(0, 1000), "iterations of level"),
        "iterations by level, finest first",
    )  # fmt: skip
    radii: tuple[int, ...] = parameter(
        (8, 16, EVERYWHERE), Several(Integer(0, EVERYWHERE), "radius of level"),
        f"largest search radius by level, finest first; {EVERYWHERE} for everywhere",
    )  # fmt: skip
    start: str = parameter(
        "vote", Choice(STARTS), "how a level begins: with a vote of the matches, or bilinear"
    )
    scale_space: bool = parameter(False, Flag(), "compare pixels at several scales, not patches")
    depth: int = parameter(3, Integer(1, 4), "D, number of scales")
    means: str = parameter("mip", Choice(MEANS), "scales: texels of coarser levels, or boxes")
    unread_terms: bool = parameter(True, Flag(), "do not read guides that have no weight")
    renewal_level: int = parameter(
        2, Integer(0, 11),
        "level of a warm frame that is searched anew, to replace matches that have grown old; 0 "
        "for none",
    )  # fmt: skip
    warm_mu: int = parameter(
        2,
        Integer(0, MU_ONE),
        "weight of the style in sixteenths at the finest level, in warm frames",
    )
    warm_radius: int = parameter(
        8, Integer(0, EVERYWHERE), "largest search radius at the finest level, in warm frames"
    )
    warm_iterations: int = parameter(
        1, Integer(0, 1000),
        "iterations at the finest level, in warm frames; each after the first searches only where "
        "matches moved in the one before",
    )  # fmt: skip
    dense_finish: bool = parameter(False, Flag(), "end with a match for every pixel; slower")
    labels: bool = parameter(True, Flag(), "match only pixels of the same label")
    packing: str = parameter(
        "auto", Choice(PACKINGS),
        "how guides become bytes: packed: as the thesis does for a red object on a white stage; "
        "all: the same guides unpacked; pca: principal components; auto: packed where nothing is "
        "lost by it, else pca",
    )  # fmt: skip

    def __post_init__(self) -> None:
        check_fields(self)
        for name in ("mu", "iterations", "radii"):
            if not getattr(self, name):
                raise InputError("is empty; it must have a number at least", parameter=name)
        if self.dense_finish and self.scale_space:
            raise InputError(
                "compares patches, which scale_space replaces; leave out one of them",
                parameter="dense_finish",
            )
        least = self.patch_width // 2 + 1
        if self.spacing is not None and not least <= self.spacing <= self.patch_width:
            raise InputError(
                f"is {self.spacing}; with a patch_width of {self.patch_width} it must be from "
                f"{least} to {self.patch_width}",
                parameter="spacing",
            )

    @classmethod
    def preset(cls, name: str, **changes: Any) -> "RealtimeParams":
        """Parameters of a preset, some of them changed.

        Raises
        ------
        InputError
            If there is no such preset, or a value is out of range.
        """
        if name not in REALTIME_PRESETS:
            known = ", ".join(map(repr, REALTIME_PRESETS))
            raise InputError(f"is {name!r}; it must be one of {known}", parameter="preset")
        return cls(**{**REALTIME_PRESETS[name], **changes})

    @property
    def step(self) -> int:
        """Pixels from entry to entry of the grid."""
        return self.patch_width // 2 + 1 if self.spacing is None else self.spacing

    def mu_at(self, level: int) -> int:
        """μ of a level in sixteenths."""
        return _at(self.mu, level)

    def iterations_at(self, level: int) -> int:
        """Iterations of a level."""
        return _at(self.iterations, level)

    def radius_at(self, level: int, height: int, width: int) -> int:
        """Largest radius of the random search in a source of ``height`` x ``width`` pixels."""
        return min(max(height, width) // 2, _at(self.radii, level))

    @property
    def of_warm_frames(self) -> "RealtimeParams":
        """Those by which a warm frame searches: coarse levels serve renewal alone, and do half."""
        mu, iterations, radii = (
            [at(level) for level in range(self.levels)]
            for at in (self.mu_at, self.iterations_at, partial(_at, self.radii))
        )
        return replace(
            self,
            mu=tuple(mu if self.scale_space else [self.warm_mu, *mu[1:]]),
            iterations=(self.warm_iterations, *((count + 1) // 2 for count in iterations[1:])),
            radii=(self.warm_radius, *radii[1:]),
        )

    @property
    def renewed_from(self) -> int:
        """The level from which a warm frame renews matches; 0 if none, or if it reads no guides."""
        level = min(self.renewal_level, self.levels - 1)
        return level if self.reads_guides(level) else 0

    def reads_guides(self, level: int) -> bool:
        """Whether a level's search reads the guides."""
        return self.mu_at(level) < MU_ONE or not self.unread_terms

    def reads_style(self, level: int) -> bool:
        """Whether a level's search reads B'."""
        return self.mu_at(level) > 0


def _at(values, level):
    return values[min(level, len(values) - 1)]


_THESIS = {
    "mu": (16, 16, 8, 8, 0, 0), "iterations": (2,), "radii": (EVERYWHERE,), "start": "bilinear",
    "labels": False, "warm_iterations": 2,
}  # fmt: skip

REALTIME_PRESETS: dict[str, dict[str, Any]] = {
    "best": {},
    "quick": {
        "mu": (16, 4, 4, 4, 0), "iterations": (1, 3, 4, 8), "radii": (0, 4, 16, EVERYWHERE),
    },
    "simple": _THESIS,
    "optimized": {**_THESIS, "scale_space": True},
}  # fmt: skip
"""``best`` and ``quick`` for use; the thesis' simple method, and its optimized one (chapter 6)."""


def as_realtime_params(params: RealtimeParams | str | None) -> RealtimeParams:
    """Parameters, those of a preset, or the defaults."""
    if params is None:
        return RealtimeParams()
    return RealtimeParams.preset(params) if isinstance(params, str) else params
