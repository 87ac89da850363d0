"""Whole frames of the real-time method: cold, warm, after a stroke, and with a dense finish."""

from dataclasses import replace

from oracle.stages.realtime import STAGES as LEVEL_STAGES
from oracle.stages.realtime_level import params_of
from oracle.stages.stage import Stage
from stylit_ref.realtime.session import Session


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


_PASSES = *dict.fromkeys(n for stage in LEVEL_STAGES.values() for n in stage.passes), "mark_labels"

STAGES = {
    "frame": Stage(_frame, _PASSES),
    "warm_frame": Stage(_warm_frame, _PASSES),
    "stroke": Stage(_stroke, _PASSES),
    "finish": Stage(_finish, _PASSES),
}
