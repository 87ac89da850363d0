"""Put the arrays of a case of the real-time method into the forms that the library takes."""

from typing import NamedTuple

import numpy as np

from stylit_ref.machine.vector_patch import STYLE_LANES
from stylit_ref.realtime.exemplar import Exemplar
from stylit_ref.realtime.layout import Layout
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.realtime.passes.image import Image, make_image
from stylit_ref.realtime.passes.search import Grid
from stylit_ref.realtime.refinement import Refinement
from stylit_ref.realtime.target import Target

LEVEL = "make_fill", "make_halve", "make_insert_style", "make_box_records", "make_mip_records"
"""Passes that prepare a level."""

LABELS = "mark_labels", "decimate_labels", "free_lost_labels"

SHAPING = (
    "patch_width", "spacing", "levels", "mu", "terms", "iterations", "radii", "start",
    "scale_space", "depth", "means", "renewal_level",
    "warm_mu", "warm_radius", "warm_iterations",
)  # fmt: skip
"""The parameters of a case that are those of the library."""


class Level(NamedTuple):
    """One level of a source and a target."""

    exemplar: Exemplar
    target: Target
    refinement: Refinement


def params_of(parameters: dict) -> RealtimeParams:
    """The library's parameters; what a case says of one level holds for all."""
    given = {name: parameters[name] for name in SHAPING if name in parameters}
    for name in ("mu", "iterations", "radii"):
        if name in given:
            given[name] = tuple(np.atleast_1d(given[name]).tolist())
    return RealtimeParams(**given)


def level_of(passes, parameters: dict, arrays: dict) -> Level:
    """The level that a case describes, ready to be searched."""
    params = params_of(parameters | {"levels": 1})
    source, style = arrays["source_guides"], arrays["source_style"]
    layout = Layout(params, source.shape[2], passes)
    exemplar = Exemplar(*source.shape[:2], layout)
    exemplar.set_guides(source)
    exemplar.set_style(style)
    exemplar.join()
    exemplar.set_labels(arrays.get("source_labels"))
    target = Target(*arrays["target_guides"].shape[:2], layout)
    target.set_guides(arrays["target_guides"])
    fill_style(passes, arrays["target_style"], target.picture[0])
    target.picture_changed(0)
    target.set_labels(arrays.get("target_labels"), exemplar.has_label)
    return Level(exemplar, target, Refinement(layout, tuple(parameters["guide_weights"])))


def grid_of(level: Level) -> Grid:
    """The entries of a level as the search takes them."""
    layout = level.exemplar.layout
    spacing = level.target.read_at(0, layout)[2]
    labels = level.target.labels[0], level.exemplar.labels[0]
    return Grid(layout.params.step, spacing, layout.margin, *labels)


def fill_style(passes, style, image: Image) -> None:
    """Put a picture into an image of the style."""
    passes.make_fill(3, STYLE_LANES)(np.ascontiguousarray(style).reshape(-1), image)


def style_image(passes, style, layout: Layout) -> Image:
    """A picture as an image of the style."""
    image = make_image(*style.shape[:2], layout.border, STYLE_LANES)
    fill_style(passes, style, image)
    return image
