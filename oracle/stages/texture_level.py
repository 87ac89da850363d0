"""Put the arrays of a case of texture synthesis into the forms that the library takes."""

from typing import NamedTuple

import numpy as np
from scipy.ndimage import distance_transform_edt

from stylit_ref.randomness.random_stream import random_stream
from stylit_ref.texture.formulae.polar import BLOCKED, MARGIN, Polar, halvings
from stylit_ref.texture.passes.context import Context, read_context
from stylit_ref.texture.passes.layout import Settings, Sources, Texture
from stylit_ref.texture.passes.lock import hidden_beside_locked, hidden_by_guide, magnitude
from stylit_ref.texture.passes.placement import PREDICATES
from stylit_ref.texture.passes.seam_maps import seam_maps

CHOICES = {
    "max_jump": 1, "max_shift": 0, "new_limit": 0, "existing_limit": 0, "hidden_limit": 0,
    "penalty": 0, "second_pass": False, "prescreened": 1, "spread": 0, "coherence": 0, "tries": 1,
    "guide_weight": 0, "predicate": "exact", "fractions": False, "radius": 1, "eta": 1,
    "exponent": 1,
}  # fmt: skip
"""What a stage leaves alone has these values; they are of no account."""

PLACES = "cut_x", "cut_y", "step_x", "step_y", "inside"
"""The tables of T that have an entry for every row and column."""


_ANY_EXEMPLAR = -1


class Scene(NamedTuple):
    """What the passes of a patch share."""

    texture: Texture
    sources: Sources
    polar: Polar
    settings: Settings


def scene_of(parameters: dict, arrays: dict) -> Scene:
    """The scene that a case describes; the seams of S are counted.

    Parameters
    ----------
    parameters : dict
    arrays : dict of str to array
        ``addresses``, ``colours``, ``valid`` and possibly ``lock``, ``guide``, ``guide_colours``,
        ``ring`` and the tables of T.
    """
    given = CHOICES | {name: parameters[name] for name in CHOICES if name in parameters}
    valid = arrays["valid"]
    stride, clearance = valid.shape[1], clearance_of(valid)
    lock = arrays.get("lock", np.zeros((1, 1), np.bool_))
    # A stage that does not look at S has none; any pixel with neighbours will do.
    addresses = arrays.get("addresses", np.full(lock.shape, stride + 1, np.int32)).copy()
    settings = Settings(
        stride=stride,
        plane=valid.size,
        has_lock=int("lock" in arrays and arrays["lock"].any()),
        has_labels=0,
        **given
        | {
            "predicate": PREDICATES.index(given["predicate"]),
            "second_pass": int(given["second_pass"]),
            "fractions": int(given["fractions"]),
        },
    )
    empty = np.zeros((1, 1), np.int32)  # in the place of what a stage does not read
    locked = np.broadcast_to(lock, addresses.shape).astype(np.uint8)
    seams = np.empty((2, *addresses.shape), np.int32)
    texture = Texture(
        addresses, *seams, locked, np.zeros((1, 1), np.uint8), arrays.get("guide", empty)
    )
    centres = centres_of(clearance, settings.radius)
    sources = Sources(
        colours=arrays.get("colours", np.zeros(valid.size, np.int32)),
        guide_colours=arrays.get("guide_colours", empty[0]),
        clearance=clearance.ravel(),
        centres=centres,
        bounds=np.array([0, valid.size], np.int64),
        centre_bounds=np.array([0, centres.size], np.int64),
        ring=arrays.get("ring", np.zeros((64, 2), np.int32)),
        prices=np.zeros(valid.size, np.int64),
    )
    seam_maps(
        addresses, sources.colours, settings.stride, settings.eta, settings.exponent,
        texture.seams_x, texture.seams_y,
    )  # fmt: skip
    tables = {
        name: arrays.get(name, empty if name in PLACES else empty[0]) for name in Polar._fields
    }
    polar = Polar(**tables | {"half_width": half_widths(settings.radius)})
    return Scene(texture, sources, polar, settings)


def half_widths(radius):
    """How far the disc of radius R + 1.5 reaches in each row of a window."""
    offsets = np.arange(-radius - MARGIN, radius + MARGIN + 1)
    return np.sqrt(np.maximum((2 * radius + 3) ** 2 - 4 * offsets**2, 0) // 4).astype(np.int32)


def clearance_of(valid):
    """Whole pixels to the nearest pixel that is not valid."""
    return distance_transform_edt(valid).astype(np.uint16)


def centres_of(clearance, radius):
    """Addresses where the centre of a patch may lie."""
    return np.flatnonzero(2 * clearance.astype(np.int32) > radius).astype(np.int32)


def context_of(scene: Scene, y: int, x: int) -> Context:
    """What lies under a patch."""
    half_width = half_widths(scene.settings.radius)
    rooms = [np.zeros(half_width.size**2, np.int32) for _ in Context._fields[:-1]]
    context = Context(*rooms, np.zeros(half_width.size**2, np.uint8))
    read_context(
        scene.texture, scene.sources.colours, scene.settings.stride, y, x, half_width,
        _ANY_EXEMPLAR, context,
    )  # fmt: skip
    return context


def hidden_by(scene: Scene, context: Context, source: int, y: int, x: int):
    """What each pixel of a window saves if a patch covers it, and how often costs are halved."""
    texture, sources, polar, settings = scene
    window = settings, source, y, x, polar.half_width, context
    if settings.has_lock:
        hidden = np.zeros_like(context.seams)
        hidden_beside_locked(texture, sources.colours, *window, hidden)
    else:
        hidden = context.seams.copy()
    if settings.guide_weight:
        hidden_by_guide(texture, sources.guide_colours, *window, hidden)
    return hidden, halvings.py_func(magnitude(hidden), settings.hidden_limit)


def stream_of(parameters, purpose):
    """The random numbers of an iteration."""
    high, low = divmod(parameters.get("iteration", 0), 1 << 16)
    return random_stream(parameters["seed"], purpose, vote=high, iteration=low)


def padded(table, max_jump, beside):
    """A table of (n, H, W) as the passes take it: (H, n (W + 2 J)).

    Parameters
    ----------
    table : (n, H, W) int32
    max_jump : int
    beside : pair of callable
        Give the columns on the left and on the right from a table.
    """
    left, right = (np.repeat(column(table), max_jump, axis=2) for column in beside)
    wide = np.concatenate([left, table, right], axis=2)
    return np.ascontiguousarray(wide.transpose(1, 0, 2).reshape(table.shape[1], -1))


def padded_crossing(crossing, max_jump):
    """Crossings: blocked on either side."""
    blocked = np.full((*crossing.shape[:2], 1), BLOCKED, np.int32)
    return padded(crossing, max_jump, (lambda _: blocked,) * 2)


def padded_steps(steps, max_jump):
    """Running sums: they go on as they end."""
    sides = (lambda table: np.zeros_like(table[:, :, :1])), (lambda table: table[:, :, -1:])
    return padded(steps, max_jump, sides)
