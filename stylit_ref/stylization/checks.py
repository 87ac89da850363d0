"""What ``stylize`` refuses before it starts; every refusal is one sentence with the sizes."""

import logging
from collections.abc import Sequence
from dataclasses import replace
from os import PathLike

import numpy as np
from numpy.typing import ArrayLike, NDArray

from stylit_ref.arrays import as_array
from stylit_ref.errors import InputError
from stylit_ref.formulae.patch_penalization import omega_best
from stylit_ref.metric.lower_bound import BOUND_SCALE
from stylit_ref.metric.packing import ONE, Packing, occurrence_weight
from stylit_ref.notes import note
from stylit_ref.stylization.exemplar import Exemplar
from stylit_ref.stylization.params import ALL, MOST_LEVELS, Params
from stylit_ref.stylization.target import Target


def size_text(shape: tuple[int, ...]) -> str:
    """Width and height of an array shape, as people write them: ``300x228``."""
    return f"{shape[1]}x{shape[0]}"


def as_image(array: ArrayLike, name: str) -> NDArray[np.uint8]:
    """The array as (H, W, n) uint8."""
    if isinstance(array, str | PathLike):
        raise InputError("is a path; read the file with read_uint8", parameter=name)
    array = as_array(array, name)
    if array.dtype != np.uint8:
        raise InputError(
            f"has dtype {array.dtype}; it must be uint8 (to_uint8 converts)", parameter=name
        )
    if array.ndim == 2:
        array = array[:, :, None]
    if array.ndim != 3 or 0 in array.shape:
        raise InputError(
            f"has shape {array.shape}; it must be (H, W) or (H, W, channels)", parameter=name
        )
    return array


def check_source_guides(
    style: NDArray[np.uint8],
    sources: Sequence[NDArray[np.uint8]],
    names: Sequence[str] | None = None,
) -> None:
    """Guides of the source fit the style.

    ``names`` are what the images are called in a refusal.
    """
    if not sources:
        raise InputError("is empty; at least one guide is needed", parameter="source_guides")
    for source, name in zip(sources, names or _names("source_guides", sources), strict=True):
        if source.shape[:2] != style.shape[:2]:
            raise InputError(
                f"is {size_text(source.shape)} but the style is {size_text(style.shape)}; "
                "they must have the same size",
                parameter=name,
            )


def check_target_guides(
    targets: Sequence[NDArray[np.uint8]],
    channels: Sequence[int],
    names: Sequence[str] | None = None,
    source_names: Sequence[str] | None = None,
) -> None:
    """Guides of the target fit each other and those of the source, by their ``channels``."""
    if len(channels) != len(targets):
        raise InputError(
            f"holds {len(targets)} guides but source_guides holds {len(channels)}; each source "
            "guide needs its target",
            parameter="target_guides",
        )
    names = names or _names("target_guides", targets)
    source_names = source_names or _names("source_guides", channels)
    for target, wanted, name, source_name in zip(
        targets, channels, names, source_names, strict=True
    ):
        if target.shape[:2] != targets[0].shape[:2]:
            raise InputError(
                f"is {size_text(target.shape)} but {names[0]} is {size_text(targets[0].shape)}; "
                "they must have the same size",
                parameter=name,
            )
        if target.shape[2] != wanted:
            raise InputError(
                f"has {wanted} channels but {name} has {target.shape[2]}; they must have the same "
                "number",
                parameter=source_name,
            )


def check_guides(
    style: NDArray[np.uint8],
    sources: Sequence[NDArray[np.uint8]],
    targets: Sequence[NDArray[np.uint8]],
    source_names: Sequence[str] | None = None,
    target_names: Sequence[str] | None = None,
) -> None:
    """Guides come in pairs and fit the style and each other."""
    channels = [guide.shape[2] for guide in sources]
    if len(sources) == len(targets):
        _check_order(style, sources, targets, source_names, target_names)
        check_source_guides(style, sources, source_names)
    check_target_guides(targets, channels, target_names, source_names)


def _check_order(style, sources, targets, source_names, target_names):
    """Name a pair whose target has the style's size and whose source has not."""
    source_names = source_names or _names("source_guides", sources)
    target_names = target_names or _names("target_guides", targets)
    for source, target, name, other in zip(
        sources, targets, source_names, target_names, strict=True
    ):
        if source.shape[:2] != style.shape[:2] == target.shape[:2]:
            raise InputError(
                f"is {size_text(source.shape)} but the style is {size_text(style.shape)}, as "
                f"{other} is: source and target look swapped; name the source first",
                parameter=name,
            )


def _names(parameter, guides):
    return [f"{parameter}[{k}]" for k in range(len(guides))]


def check_mask(mask: NDArray[np.bool_], target_size: tuple[int, int]) -> None:
    """A mask has the target's size, and something is left to synthesize."""
    if mask.dtype != bool or mask.ndim != 2:
        raise InputError(
            f"is {mask.dtype} of shape {mask.shape}; it must be bool of shape (H, W)",
            parameter="mask",
        )
    if mask.shape != target_size:
        raise InputError(
            f"is {size_text(mask.shape)} but the target is {size_text(target_size)}; "
            "they must have the same size",
            parameter="mask",
        )
    if mask.all():
        raise InputError(
            "covers the whole target, so nothing is left to synthesize", parameter="mask"
        )


def check_fill(fill: np.ndarray, target_size: tuple[int, int]) -> None:
    """A fill is an image of the target's size: grey or colour, with or without alpha."""
    if fill.shape[:2] != target_size:
        raise InputError(
            f"is {size_text(fill.shape)} but the target is {size_text(target_size)}; "
            "they must have the same size",
            parameter="fill",
        )
    channels = fill.shape[2] if fill.ndim == 3 else 1
    if fill.ndim > 3 or not 1 <= channels <= 4:
        raise InputError(
            f"has shape {fill.shape}; it must be grey or RGB, with or without alpha",
            parameter="fill",
        )


def fit_levels(
    params: Params, source_size: tuple[int, int], target_size: tuple[int, int]
) -> Params:
    """Fewer levels where the coarsest would be smaller than a patch."""
    for name, shape in (("source", source_size), ("target", target_size)):
        if min(shape) < params.patch_width:
            raise InputError(
                f"is {params.patch_width} but the {name} is {size_text(shape)}; "
                "a patch must fit into the image",
                parameter="patch_width",
            )
    most = most_levels(params.patch_width, source_size, target_size)
    if params.levels == ALL or params.levels <= most:
        return params
    note(
        f"is {params.levels}, but {most} are used: a coarser level would be smaller than a patch",
        parameter="levels",
    )
    return replace(params, levels=most)


def most_levels(
    patch_width: int, source_size: tuple[int, int], target_size: tuple[int, int]
) -> int:
    """As many levels as the coarsest still holds a patch; sizes halve and are rounded down."""
    levels, shortest = 1, min(*source_size, *target_size)
    while shortest >> levels >= patch_width and levels < MOST_LEVELS:
        levels += 1
    return levels


def check_halves(exemplar: Exemplar, target: Target, params: Params) -> None:
    """Exemplar, target and parameters of a run belong together, and its integers fit."""
    if not exemplar.packing.agrees_with(target.packing) or exemplar.passes is not target.passes:
        raise InputError(
            "exemplar and target are not packed alike; they need the same guides, weights and "
            "backend (make_target takes them from the exemplar)"
        )
    widths = exemplar.patch_width, target.patch_width, params.patch_width
    if len(set(widths)) > 1:
        raise InputError(
            "is {2}, but the exemplar was made for {0} and the target for {1}".format(*widths),
            parameter="patch_width",
        )
    shortest = min(*exemplar.size, *target.size) >> (params.levels - 1)
    if shortest < params.patch_width:
        raise InputError(
            f"is {params.levels}, but the coarsest level would be smaller than a patch of width "
            f"{params.patch_width}",
            parameter="levels",
        )
    patches = int(np.count_nonzero(target.synthesized(0)))
    check_range(exemplar.packing, params, exemplar.size, patches)


def check_nnf(
    nnf: NDArray[np.int32],
    exemplar_size: tuple[int, int],
    synthesized: NDArray[np.bool_],
    patch_width: int,
) -> None:
    """An NNF to begin with: a source patch for every target patch that takes part, and no other."""
    shape = *synthesized.shape, 2
    if nnf.dtype != np.int32 or nnf.shape != shape:
        raise InputError(
            f"is {nnf.dtype} of shape {nnf.shape}; it must be int32 of shape {shape}",
            parameter="nnf",
        )
    radius = patch_width // 2
    last = np.array(exemplar_size) - 1 - radius
    inside = ((nnf >= radius) & (nnf <= last)).all(axis=2)
    absent = (nnf < 0).all(axis=2)
    if not np.where(synthesized, inside, absent).all():
        raise InputError(
            f"must hold source centres from {[radius, radius]} to {last.tolist()} where the target "
            "is synthesized, and -1 elsewhere",
            parameter="nnf",
        )


def check_range(
    packing: Packing, params: Params, source_size: tuple[int, int], target_patches: int
) -> None:
    """The integers of the metric must fit: W 32 bits; φ, times the scale of its bound, 64."""
    patch_pixels = params.patch_width**2
    if target_patches * patch_pixels >= 1 << 31:
        raise InputError(
            f"is {params.patch_width}, and {target_patches} target patches of that width overflow "
            f"the occurrence map; at most {(1 << 31) // patch_pixels} are possible, so take a "
            "smaller width or a smaller image",
            parameter="patch_width",
        )
    source_pixels = source_size[0] * source_size[1]
    uniformity = params.penalization
    weight = occurrence_weight(uniformity, params.patch_width, source_pixels, target_patches)
    best = omega_best(params.patch_width, source_pixels, target_patches)
    exact = uniformity / (patch_pixels * best)
    if abs(weight - ONE * exact) > 0.01 * ONE * exact:
        note(
            f"is {uniformity:g}, but {uniformity * weight / (ONE * exact):g} is used: the nearest "
            f"fixed-point value with patches of width {params.patch_width}",
            parameter="uniformity",
            level=logging.WARNING,
        )
    largest_phi = weight * patch_pixels * target_patches + packing.largest_delta(params.patch_width)
    factor = patch_pixels if params.traits.has_guide_map else BOUND_SCALE
    if largest_phi * factor >= 1 << 62:
        raise InputError(
            f"is {uniformity:g}; with guide_influence {params.guide_influence:g} it overflows "
            "64-bit integers on images of this size; choose smaller values",
            parameter="uniformity",
        )
