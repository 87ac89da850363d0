"""An iteration of a frame that others pull at, and whole coherent runs."""

import numpy as np

from oracle.stages.stage import Stage
from stylit_ref import Params
from stylit_ref.views.frames import Motion
from stylit_ref.views.params import Coherence
from stylit_ref.views.plan import Task
from stylit_ref.views.problem import make_problem
from stylit_ref.views.shot import ArrayShot
from stylit_ref.views.stylize_views import stylize_views
from stylit_ref.views.work.state import State
from stylit_ref.views.work.workbench import Workbench

METHODS_OWN = "uniformity", "epsilon", "budget", "fixed_share", "error_limit"
"""Parameters that only some methods have."""


def _params(parameters):
    return Params(
        parameters["method"],
        patch_width=parameters["patch_width"],
        levels=parameters["levels"],
        votes=parameters["votes"],
        vote_outliers=parameters["outliers"],
        patchmatch_iterations=parameters["iterations"],
        guide_influence=parameters["guide_influence"],
        guide_weights=parameters["guide_weights"],
        **{name: parameters[name] for name in METHODS_OWN if name in parameters},
    )


def _coherence(parameters):
    return Coherence(
        parameters["coherence"],
        parameters["form"],
        parameters["order"],
        parameters.get("following_votes"),
    )


def _split(parameters, guides):
    return np.split(guides, np.cumsum(parameters["guide_channels"])[:-1], axis=2)


def _numbers(arrays, name):
    """What follows a name and ``_`` in the names of arrays, in rising order."""
    return sorted(
        tuple(map(int, each.removeprefix(f"{name}_").split("_")))
        for each in arrays
        if each.startswith(f"{name}_")
    )


def _iteration(_, parameters, arrays):
    """Frame 0 advances; which order its task is of does not matter to it."""
    others = [number for (number,) in _numbers(arrays, "picture")]
    guides = _split(parameters, arrays["target_guides"])
    edges = {
        (0, number): Motion(arrays[f"field_{number}"], arrays[f"visible_{number}"])
        for number in others
    }
    shot = ArrayShot([guides] * (1 + max(others, default=0)), edges)
    problem = make_problem(
        arrays["style"], _split(parameters, arrays["source_guides"]), shot, _params(parameters),
        _coherence(parameters | {"order": "parallel"}), seed=parameters["seed"],
    )  # fmt: skip
    state = Workbench(problem).make(
        Task(0, parameters["level"], parameters["vote"]),
        State(arrays["nnf"], arrays["picture"]),
        {number: arrays[f"picture_{number}"] for number in others},
    )
    return {"nnf": state.nnf, "picture": state.picture}


def _run(_, parameters, arrays):
    frames = [
        _split(parameters, arrays[f"target_guides_{frame}"])
        for (frame,) in _numbers(arrays, "target_guides")
    ]
    edges = {
        (to, other): Motion(arrays[f"field_{to}_{other}"], arrays[f"visible_{to}_{other}"])
        for to, other in _numbers(arrays, "field")
    }
    results = stylize_views(
        arrays["style"], _split(parameters, arrays["source_guides"]), frames, _params(parameters),
        _coherence(parameters), edges=edges, seed=parameters["seed"],
    )  # fmt: skip
    found = {}
    for result in results:
        found |= {f"picture_{result.frame}": result.image, f"nnf_{result.frame}": result.nnf}
    return found


STAGES = {"iteration": Stage(_iteration), "run": Stage(_run)}
