"""A key for every state: a digest of all that it depends on."""

import hashlib
from collections.abc import Mapping

from stylit_ref.machine.code_digest import code_digest
from stylit_ref.views.plan import Plan, Task
from stylit_ref.views.problem import Problem
from stylit_ref.views.shot import Shot, arrays_digest
from stylit_ref.views.work import workbench


def code_key(shot: Shot) -> str:
    """A digest of the code that makes states, and of that which reads the shot."""
    return _digest(code_digest(workbench), shot.code)


def keys_of(problem: Problem, plan: Plan) -> Mapping[Task, str]:
    """The keys of all tasks of a plan.

    A key covers the code, the style with its guides, the parameters and the seed; the guides of the
    frame, and how many iterations it takes; and, of every picture that pulls, its key, its weight
    and the motion. Whatever changes, the states that do not depend on it keep their keys.

    Parameters
    ----------
    problem : Problem
    plan : Plan
        Of the problem.

    Returns
    -------
    mapping of Task to str
        Hexadecimal digits.
    """
    shot, coherence = problem.shot, problem.coherence
    common = (
        code_key(shot),
        arrays_digest(problem.style, *problem.source_guides),
        repr((problem.params, problem.seed)),
    )
    guides = [
        _digest(*common, repr(list(plan.votes_of(frame))), shot.guides_digest(frame))
        for frame in plan.frames
    ]
    motion = {
        (to, other): _digest(
            shot.motion_digest(to, other), repr((coherence.weight, coherence.form))
        )
        for to in plan.frames
        for other in plan.neighbours[to]
    }
    keys: dict[Task, str] = {}
    for task in plan.tasks():
        before = plan.before(task)
        facts = [guides[task.frame], f"{task.level} {task.vote}", keys[before] if before else ""]
        for other in plan.pulling(task):
            facts += [keys[other], motion[task.frame, other.frame]]
        keys[task] = _digest(*facts)
    return keys


def _digest(*texts):
    return hashlib.sha256("\n".join(texts).encode()).hexdigest()[:32]
