"""Which kernels coherent frames need."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from stylit_ref.machine.compilation import Specialization
from stylit_ref.machine.kernel import rehearsal
from stylit_ref.stylization.params import Params
from stylit_ref.stylization.warm_up import rehearsing_backend
from stylit_ref.views.frames import Motion, sequence_pairs
from stylit_ref.views.params import Coherence
from stylit_ref.views.problem import make_problem
from stylit_ref.views.shot import ArrayShot
from stylit_ref.views.work.workbench import Workbench


def kernels_of_frames(
    params: Params, coherence: Coherence, style_channels: int, guide_channels: Sequence[int]
) -> list[Specialization]:
    """The kernels that frames call which pull at each other.

    They are found out by two small frames in which they do nothing, as by
    :func:`stylit_ref.stylization.warm_up.kernels_of_run`.

    Parameters
    ----------
    params : Params
    coherence : Coherence
    style_channels : int
    guide_channels : sequence of int

    Returns
    -------
    list of Specialization
        In the order of their first calls. Those that turn vectors around are not among them.

    Raises
    ------
    InputError
        If the parameters and channels do not fit together.
    """
    side = 2 * params.patch_width  # two levels, as in a run's rehearsal
    black = [np.zeros((side, side, channels), np.uint8) for channels in guide_channels]
    style = np.zeros((side, side, style_channels), np.uint8)
    still = Motion(np.zeros((side, side, 2), np.float32), np.ones((side, side), np.bool_))
    shot = ArrayShot([black, black], dict.fromkeys(sequence_pairs(2), still))
    short = replace(params, levels=2, votes=1, patchmatch_iterations=1, uniformity=0)
    coherence = replace(coherence, following_votes=None)
    with rehearsal() as rehearsed:
        problem = make_problem(style, black, shot, short, coherence)
        bench, plan, states = Workbench(problem, rehearsing_backend()), problem.plan(), {}
        for task in plan.tasks():
            before = plan.before(task)
            pictures = {other.frame: states[other].picture for other in plan.pulling(task)}
            states[task] = bench.make(task, states.get(before), pictures)
    return list(rehearsed)
