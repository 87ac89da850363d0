"""What frames need again is kept (``test_kept`` shows that no byte depends on it)."""

from collections import Counter

from small_shot import EFFORT, sliding

from stylit_ref import ArrayShot, Params
from stylit_ref.views.problem import make_problem
from stylit_ref.views.work.keys import keys_of
from stylit_ref.views.work.walk import Walk
from stylit_ref.views.work.work_folder import WorkFolder
from stylit_ref.views.work.workbench import Workbench


class Counting(ArrayShot):
    def __init__(self, *arguments):
        super().__init__(*arguments)
        self.read = Counter()

    def motion(self, to, other):
        self.read[to, other] += 1
        return super().motion(to, other)


def test_motion_of_each_pair_is_read_once_while_frames_take_turns(tmp_path):
    scene = sliding(frames=3)
    shot = Counting(scene.guides, scene.edges)
    problem = make_problem(scene.style, scene.sources, shot, Params(**EFFORT))
    keys = keys_of(problem, problem.plan())
    list(Walk(problem, WorkFolder(tmp_path), Workbench(problem), keys).run())
    assert shot.read == dict.fromkeys(shot.pairs, 1)
