"""Where states are made: one search-vote iteration of one frame at a time."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.randomness.random_stream import RANDOM_NNF, random_stream
from stylit_ref.stylization.backends import CPU, Backend
from stylit_ref.stylization.checks import as_image, check_range, check_target_guides, size_text
from stylit_ref.stylization.exemplar import Exemplar
from stylit_ref.stylization.level import Level
from stylit_ref.stylization.mask import active_patches, downsample_mask
from stylit_ref.stylization.problem import make_exemplar
from stylit_ref.stylization.schedules import SCHEDULES
from stylit_ref.stylization.target import TargetLevel
from stylit_ref.views.coherence import Neighbour, places_of, pull, without_masked
from stylit_ref.views.formulae.fold import ONE
from stylit_ref.views.frames import check_edges
from stylit_ref.views.packing import coherent_packing
from stylit_ref.views.params import PLAIN
from stylit_ref.views.plan import Task
from stylit_ref.views.problem import Problem
from stylit_ref.views.work.kept import Kept
from stylit_ref.views.work.state import State

ROOM = 512 << 20
"""Bytes for what frames need again: packed guides, levels, and where their pixels lie in others."""


class Workbench:
    """Makes the states of frames. It keeps what it can, but no state depends on what it kept.

    Parameters
    ----------
    problem : Problem
    backend : Backend
    room : int
        Bytes for what is kept of frames; the exemplar comes on top.

    Raises
    ------
    InputError
        If images and parameters do not fit together; the first frame is looked at.
    """

    def __init__(self, problem: Problem, backend: Backend = CPU, room: int = ROOM) -> None:
        self._problem, self._backend = problem, backend
        self._plan, self._kept = problem.plan(), Kept(room)
        exemplar = make_exemplar(
            problem.style, problem.source_guides, problem.params, backend=backend
        )
        self._exemplars = {(ONE, False): exemplar}
        height, width = problem.shot.size
        check_range(exemplar.packing, problem.params, exemplar.size, height * width)
        self._guides(0)

    def make(
        self,
        task: Task,
        before: State | None,
        pictures: Mapping[int, NDArray[np.uint8]],
    ) -> State:
        """Do a task.

        Parameters
        ----------
        task : Task
        before : State or None
            The frame's own state before it; None for the first.
        pictures : mapping of int to (H, W, n) uint8
            By neighbour, what pulls: pictures of the level, or finished ones, which are halved.

        Returns
        -------
        State

        Raises
        ------
        InputError
            If guides or motion of the frame do not fit.
        """
        params, seed = self._problem.params, self._problem.seed
        level, stands_at = self._level(task)
        passes = level.passes
        if task.vote:
            assert before is not None
            if stands_at is not before:
                level.set_nnf(before.nnf)
                level.init_occurrence_map()
            neighbours = [
                Neighbour(self._places(task, other), self._halved(task, other, picture))
                for other, picture in pictures.items()
            ]
            with_spread = self._style_of(task.frame)[1]
            weight = self._problem.weight
            pull(level, before.picture, neighbours, weight, with_spread=with_spread)
            level.update_moments()
            iterate = self._backend.iterate or SCHEDULES[params.schedule]
            for _ in params.traits.search(level, params, iterate, seed, task.level, task.vote):
                pass
        elif before is None:
            stream = random_stream(seed, RANDOM_NNF, task.level)
            passes.random_nnf(level.nnf, level.patch_width, *level.omega.shape, stream)
        else:
            coarse = passes.upload(before.nnf)
            passes.upsample_nnf(coarse, level.nnf, level.patch_width, *level.omega.shape)
        level.update_style()
        state = State(np.array(passes.download(level.nnf)), np.ascontiguousarray(level.style))
        # Ω is that of the NNF only after a search: beginning a level does not need it.
        self._keep_level(task, level, state if task.vote else None)
        return state

    def forget(self, frame: int) -> None:
        """Free what was kept of a frame that is finished."""
        self._kept.forget(lambda key: key[1] == frame)

    def _depth(self, task):
        return len(self._plan.votes) - task.level

    def _style_of(self, frame):
        """The weight of the frame's style in units of 1/256, and whether the spread counts."""
        pulling = len(self._plan.neighbours[frame])
        weight = ONE
        if self._problem.coherence.form == PLAIN:
            weight += pulling * self._problem.weight
        return weight, self._problem.params.traits.chooses_targets and pulling > 0

    def _exemplar(self, frame):
        weight, with_spread = style = self._style_of(frame)
        if style not in self._exemplars:
            packing = self._exemplars[ONE, False].packing
            packing = coherent_packing(packing, weight, with_spread=with_spread)
            texture = _packed(packing, self._problem.source_guides, self._problem.style)
            width = self._problem.params.patch_width
            self._exemplars[style] = Exemplar(self._backend.passes, packing, width, texture)
        return self._exemplars[style]

    def _level(self, task):
        """The level of a task's frame, with the arrays that its search works on.

        Beside it the state whose NNF and occurrence map it holds, or None.
        """
        depth, params = self._depth(task), self._problem.params
        # Whoever fails at the task leaves no level that is half searched.
        kept = self._kept.take(("level", task.frame, depth))
        if kept is None:
            exemplar, texture = self._exemplar(task.frame), self._texture(task)
            passes, packing, width = exemplar.passes, exemplar.packing, params.patch_width
            padded = passes.repeat_edge(texture, width // 2)
            target = TargetLevel(passes, packing, width, padded, self._synthesized(task))
            level = Level(exemplar.level(depth), target, params)
            # Nobody goes back to a coarser level.
            self._kept.forget(lambda each: each[1] == task.frame and each[-1] > depth)
            return level, None
        return kept

    def _keep_level(self, task, level, state):
        size = _bytes_of(level) + (state.nbytes if state else 0)
        self._kept.add(("level", task.frame, self._depth(task)), (level, state), size)

    def _synthesized(self, task):
        """The pixels of a task's level whose patches take part; None for all."""
        mask = self._problem.shot.mask(task.frame)
        if mask is None:
            return None
        synthesized = active_patches(mask, self._problem.params.patch_width)
        for _ in range(self._depth(task)):
            synthesized = downsample_mask(synthesized)
        return synthesized

    def _texture(self, task):
        """The packed guides of a task's frame at its level."""
        kind, frame, depth = "texture", task.frame, self._depth(task)
        texture = self._kept.get((kind, frame, depth))
        if texture is None:
            exemplar = self._exemplar(frame)
            packed = _packed(exemplar.packing, self._guides(frame))
            texture = self._backend.passes.upload(packed)
            for each in range(depth + 1):
                texture = self._backend.passes.downsample(texture) if each else texture
                self._kept.add((kind, frame, each), texture, texture.nbytes)
        return texture

    def _places(self, task, other):
        """Where the pixels of a task's frame lie in another, at its level."""
        kind, frame, depth = "places", task.frame, self._depth(task)
        places = self._kept.get((kind, frame, other, depth))
        if places is None:
            shot, edge = self._problem.shot, (frame, other)
            motion = check_edges({edge: shot.motion(*edge)}, len(shot.names), shot.size)[edge]
            motion = without_masked(motion, shot.mask(other))
            for each in range(depth + 1):
                places = _compact(places_of(motion, each))
                self._kept.add((kind, frame, other, each), places, places.nbytes)
        return places.astype(np.int32, copy=False)

    def _halved(self, task, other, picture):
        """A picture in the size of the task's level; only a finished one is larger."""
        height, width = (side >> self._depth(task) for side in self._problem.shot.size)
        if picture.shape[:2] == (height, width):
            return picture
        key = "picture", task.frame, other, self._depth(task)
        halved = self._kept.get(key)
        if halved is None:
            halved = picture
            while halved.shape[:2] != (height, width):
                halved = self._backend.passes.downsample(halved)
            self._kept.add(key, halved, halved.nbytes)
        return halved

    def _guides(self, frame):
        """The guides of a frame, which must fit those of the source."""
        shot = self._problem.shot
        guides = shot.guides(frame)
        names = [f"target_guides[{frame}][{k}]" for k in range(len(guides))]
        guides = [as_image(guide, name) for guide, name in zip(guides, names, strict=True)]
        channels = [guide.shape[2] for guide in self._problem.source_guides]
        check_target_guides(guides, channels, names)
        if guides[0].shape[:2] != tuple(shot.size):
            raise InputError(
                f"is {size_text(guides[0].shape)} but the shot is {size_text(shot.size)}; all "
                "frames must have the same size",
                parameter=f"target_guides[{frame}]",
            )
        return guides


def _packed(packing, guides, style=None):
    """Guides and style in one texture, with zeros for the spread if the packing has it."""
    if len(packing.guide_sizes) > len(guides):
        guides = [*guides, np.zeros((*guides[0].shape[:2], 1), np.uint8)]
    return packing.pack(guides, style)


def _compact(places):
    """Places in half the memory, so that twice as many stay where all frames take turns."""
    fits = max(places.shape) <= np.iinfo(np.int16).max
    return places.astype(np.int16) if fits else places


def _bytes_of(level):
    """About what a level takes: its texture and moments, assignments, and occurrence maps."""
    height, width = level.nnf.shape[:2]
    packing = level.packing
    pixel = packing.channels + 2 * len(packing.moments) + 4 * packing.style_channel + 32
    return height * width * pixel + 2 * level.omega.nbytes
