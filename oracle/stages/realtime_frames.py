"""Frames of the real-time method: cold, renewed and warm, after a stroke, with a dense finish."""

from dataclasses import replace

import numpy as np

from oracle.stages.realtime import STAGES as LEVEL_STAGES
from oracle.stages.realtime_level import LABELS, LEVEL, params_of
from oracle.stages.stage import Stage
from stylit_ref.realtime.exemplar import Exemplar
from stylit_ref.realtime.formulae.packed_nnf import entries_of, places_of
from stylit_ref.realtime.layout import Layout
from stylit_ref.realtime.refinement import Refinement, renew
from stylit_ref.realtime.session import Session
from stylit_ref.realtime.target import Target


def _session(passes, parameters, arrays, dense_finish=False):
    params = replace(params_of(parameters), dense_finish=dense_finish)
    session = Session(params, seed=parameters["seed"], passes=passes)
    session.set_exemplar(
        arrays["source_guides"], arrays["source_style"], arrays.get("source_labels")
    )
    session.set_weights(parameters["guide_weights"])
    session.set_target(arrays["target_guides"], arrays.get("target_labels"))
    return session


def _frame(passes, parameters, arrays):
    session = _session(passes, parameters, arrays)
    picture = session.frame()
    return {"picture": picture, "nnf": session.nnf}


def _renew(passes, parameters, arrays):
    """The frame's own levels, halved from the finest; B' counts nothing."""
    level = parameters["renewal_level"]
    params = params_of(parameters | {"levels": level + 1})
    layout = Layout(params, arrays["source_guides"].shape[2], passes)
    exemplar = Exemplar(*arrays["source_guides"].shape[:2], layout)
    exemplar.set_guides(arrays["source_guides"])
    exemplar.set_style(np.zeros((*exemplar.size, 3), np.uint8))
    exemplar.join()
    exemplar.set_labels(arrays.get("source_labels"))
    target = Target(*arrays["target_guides"].shape[:2], layout)
    target.set_guides(arrays["target_guides"])
    target.set_labels(arrays.get("target_labels"), exemplar.has_label)
    refinement = Refinement(layout, tuple(parameters["guide_weights"]))
    nnf = {0: entries_of(arrays["nnf"]), level: entries_of(arrays["fresh"])}
    renew(exemplar, target, refinement, nnf, level)
    return {"nnf": places_of(nnf[0])}


def _warm_frame(passes, parameters, arrays):
    session = _session(passes, parameters, arrays)
    session.nnf = arrays["nnf"]
    picture = session.frame(warm=True)
    return {"picture": picture, "nnf": session.nnf}


def _stroke(passes, parameters, arrays):
    session = _session(passes, parameters, arrays)
    session.frame()
    nnf = session.nnf
    session.set_style(arrays["new_style"])
    replayed, picture = session.replay(), session.frame()
    return {"nnf": nnf, "replayed": replayed, "picture": picture, "new_nnf": session.nnf}


def _finish(passes, parameters, arrays):
    session = _session(passes, parameters, arrays, dense_finish=True)
    session.nnf = arrays["nnf"]
    return {"picture": session.replay(), "dense": session.dense_nnf()}


_PASSES = tuple(dict.fromkeys(n for stage in LEVEL_STAGES.values() for n in stage.passes))
_RENEWAL = *LEVEL, *LABELS, "make_renew"

STAGES = {
    "frame": Stage(_frame, _PASSES),
    "renew": Stage(_renew, _RENEWAL),
    "warm_frame": Stage(_warm_frame, (*_PASSES, "make_renew", "mark_moving")),
    "stroke": Stage(_stroke, _PASSES),
    "finish": Stage(_finish, _PASSES),
}
