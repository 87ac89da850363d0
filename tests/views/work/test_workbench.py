"""What frames need again is kept (``test_kept`` shows that no byte depends on it)."""

from collections import Counter

from small_shot import EFFORT, sliding

from stylit_ref import ArrayShot, Coherence, Params, passes
from stylit_ref.machine.replaced import replaced
from stylit_ref.stylization.backends import CPU, Backend
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


def made(shot, scene, folder, order="parallel", backend=CPU):
    """Yield each frame and its last state."""
    problem = make_problem(
        scene.style, scene.sources, shot, Params(**EFFORT), Coherence(order=order)
    )
    keys = keys_of(problem, problem.plan())
    return Walk(problem, WorkFolder(folder), Workbench(problem, backend), keys).run()


def test_motion_of_each_pair_is_read_once_while_frames_take_turns(tmp_path):
    scene = sliding(frames=3)
    shot = Counting(scene.guides, scene.edges)
    list(made(shot, scene, tmp_path))
    assert shot.read == dict.fromkeys(shot.pairs, 1)


def test_the_occurrence_map_is_made_once_a_level(tmp_path):
    scene, calls = sliding(frames=2), []

    def occurrence_map(*arguments):
        calls.append(1)
        passes.occurrence_map(*arguments)

    backend = Backend(replaced(passes, occurrence_map=occurrence_map))
    shot = ArrayShot(scene.guides, scene.edges)
    list(made(shot, scene, tmp_path, "sequential", backend))
    assert len(calls) == 2 * EFFORT["levels"]
