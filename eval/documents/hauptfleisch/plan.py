"""Which runs the tables, figures and claims need."""

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from eval.documents.hauptfleisch import angles, architecture, between, failures, turned
from eval.documents.hauptfleisch.costs import Costs
from eval.documents.hauptfleisch.goals import GOALS
from eval.documents.hauptfleisch.long_shot import LongShot
from eval.documents.hauptfleisch.presets import Preset
from eval.frame_sets import FrameSet
from eval.methods.views import Renderings, Views
from eval.runs.complete import Task
from eval.runs.job import Job
from stylit_ref.stylization.params import Params
from stylit_ref.views.params import Coherence

METRICS = (
    "warping", "loops", "surface_flicker", "gradient", "outlines", "guide_fidelity", "nnf_kept",
)  # fmt: skip
"""What is measured of every set of frames."""

OF_RENDERINGS = "warping", "loops", "surface_flicker", "gradient"
"""What tells something of frames without paint."""

ALONE = Coherence(0.0)


@dataclass(frozen=True)
class Study:
    """Frames, and the ways in which they are stylized.

    Attributes
    ----------
    name : str
        One of :data:`eval.documents.hauptfleisch.goals.GOALS`.
    frames : FrameSet
    ways : dict of str to tuple of Coherence
        How frames pull at each other, by method; frames alone come besides.
    methods : dict of str to Params
    """

    name: str
    frames: FrameSet
    ways: dict[str, tuple[Coherence, ...]]
    methods: dict[str, Params]

    def job(self, method, coherence, silhouettes=True):
        """The run of a method."""
        return Job(self.frames, Views(self.methods[method], coherence, silhouettes))

    def shown(self, method):
        """The settings of the pictures: those that are judged, or all if none is."""
        judged = [goal.coherence for goal in GOALS[self.name]]
        return [way for way in self.ways[method] if way in judged or not judged]

    @property
    def without_silhouettes(self):
        """Those settings with ref and the motion of surfaces; large frames are left out."""
        if self.frames.depths is None or self.name == "large":
            return []
        return [self.job("ref", way, silhouettes=False) for way in self.shown("ref")]

    def judged(self, method):
        """The runs of those settings, and that of frames alone."""
        return [self.job(method, way) for way in (ALONE, *self.shown(method))]

    def alone(self, method):
        """The run of a method without coherence: the ceiling of every error."""
        return self.job(method, ALONE)

    @property
    def floor(self):
        """The renderings themselves."""
        return Job(self.frames, Renderings())

    @property
    def jobs(self):
        """All runs of methods, frames alone before the others of their method."""
        return [
            self.job(method, way) for method, ways in self.ways.items() for way in (ALONE, *ways)
        ] + self.without_silhouettes


@dataclass(frozen=True)
class Plan:
    """The runs of a preset.

    Attributes
    ----------
    name : str
    preset : Preset
    studies : dict of str to Study
        By name; those whose data is not there are missing.
    styles : dict of str to Study
        The house in every style, that of its own study first.
    data : Path
        The data set of the house.
    turning : FrameSet, optional
        What the long shot is made of.
    thesis_size : Path, optional
        A data set of the house whose views have the thesis' size.
    """

    name: str
    preset: Preset
    studies: dict[str, Study]
    styles: dict[str, Study]
    data: Path
    turning: FrameSet | None = None
    thesis_size: Path | None = None

    def costs(self, study, method):
        """The time of coherence: frames alone, and at the setting that is judged."""
        settings = tuple(goal.coherence for goal in GOALS[study])
        params = self.preset.methods[method]
        return Job(
            self.studies[study].frames, Costs(params, (ALONE, *settings), self.preset.rounds)
        )

    @property
    def long_shot(self):
        """The run of the long shot, or None."""
        return None if self.turning is None else Job(self.turning, LongShot())

    @property
    def sketches(self):
        """Sketches that are studied without motion."""
        return self.preset.sketches if "house" in self.studies else ()

    @property
    def between(self):
        """The run of views between views, or None."""
        method = between.method(self.data)
        if "house" not in self.studies or method is None:
            return None
        return Job(self.studies["house"].frames, method)

    @property
    def of_angles(self):
        """The sketch that is seen from all sides, or None."""
        first = next(iter(self.sketches), None)
        return first if first and angles.is_rendered(self.data, first) else None

    @property
    def costed(self):
        """Studies and methods whose times are measured in turns."""
        return [each for each in self.preset.costed if each[0] in self.studies]

    @cached_property
    def tasks(self):
        """Every run once, with the metrics to measure of it."""
        tasks = {}
        of_styles = [(study, study.judged("ref")) for study in self.styles.values()]
        for study, jobs in [(study, study.jobs) for study in self.studies.values()] + of_styles:
            tasks[study.floor.file_name] = Task(study.floor, OF_RENDERINGS)
            tasks |= {job.file_name: Task(job, METRICS) for job in jobs}
        tasks |= {task.job.file_name: task for task in architecture.tasks(self.data, self.sketches)}
        if self.sketches:
            others = [
                *turned.tasks(self.data, self.preset.methods["ref"]),
                *failures.tasks(self.data),
                *(angles.tasks(self.data, self.of_angles) if self.of_angles else ()),
            ]
            tasks |= {task.job.file_name: task for task in others}
        others = [self.costs(*each) for each in self.costed]
        others += [job for job in (self.long_shot, self.between) if job is not None]
        if self.thesis_size is not None:
            others.append(architecture.job(self.thesis_size, self.sketches[0], "architecture"))
        return [*tasks.values(), *(Task(job, ()) for job in others)]
