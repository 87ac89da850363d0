"""Principal components of a general scene, the house: what they keep, and what they cost."""

import time
from dataclasses import dataclass

import numpy as np
import pandas as pd
from scipy.stats import spearmanr

from data_gen.manifest import DataError, Manifest
from eval.documents.heidrich.stage import GUIDES
from eval.metrics.image_energy import image_energy
from eval.on_processor import OnProcessor
from eval.outcome import Outcome
from eval.pages.claims import Claim, verdict
from eval.runs.complete import Task
from eval.runs.job import Job
from eval.runs.store import stored
from eval.scenes import Scene
from stylit_ref import read_uint8
from stylit_ref.machine.forks import available_threads
from stylit_ref.machine.thread_count import using_threads
from stylit_ref.realtime.packing import PrincipalPacking, pack
from stylit_ref.realtime.session import Session

SOURCE, SKETCH, TARGET = "sketched_house", "marker", "house/1_1"
"""The view that was drawn over, the drawing, and another view."""

BUFFERS = "FULL", "LDE", "LSE", "LDDE", "FRESNEL", "LIGHTMASK", "NORMAL"
"""What is packed; IDMASK becomes labels in any case."""

ROUNDS = 50
MOST_MILLISECONDS = 2.0
"""Goal of packing 500 x 500 pixels."""

LEAST_NEAREST, MOST_ENERGY = 0.95, 1.02
"""What components must keep: rank correlation of the nearest pairs, and energy over that of all
channels."""

SOME, THERE, NEAREST = 4000, 150, 40
"""Pixels of the source and of the target whose distances are compared, and how many are near."""


def house(data):
    """The house as a scene, or None if there is no data set that has it.

    Parameters
    ----------
    data : Path

    Returns
    -------
    Scene or None
    """
    try:
        manifest = Manifest.read(data)
    except DataError:
        return None
    if TARGET not in manifest.targets or SOURCE not in manifest.pieces:
        return None
    passes = {
        name: tuple(read_uint8(manifest.path(f"{view}/{name}.png")) for view in (SOURCE, TARGET))
        for name in (*BUFFERS, "IDMASK")
    }
    sources, targets = zip(*(passes[name] for name in GUIDES), strict=True)
    style = read_uint8(manifest.path(f"{SOURCE}/sketches/{SKETCH}.png"))
    return Scene(
        f"house_{SKETCH}", manifest.folder, GUIDES, style, sources, targets, 1,
        ids=passes["IDMASK"], buffers=passes,
    )  # fmt: skip


@dataclass(frozen=True)
class Components(OnProcessor):
    """Frames from principal components, and from all channels as they are.

    Attributes
    ----------
    seeds, rounds : int
        Energies are means over so many seeds; times are medians of so many.
    """

    seeds: int
    rounds: int = ROUNDS

    name = "principal components"
    cost = 20.0
    alone = True

    def run(self, scene, seed, progress=None):
        """Pack, make frames, and compare.

        Parameters
        ----------
        scene : Scene
            :func:`house`.
        seed : int
            The first.
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            The history has a row for each way of packing: ``packing``; ``bytes`` of a pixel; rank
            correlation of distances with those of all channels, of ``all`` pairs of pixels and of
            the ``nearest``; milliseconds of packing a frame on all threads (``pack``) and of the
            frame without packing (``frame``); and ``energy``. The image is that of components.
        """
        begun = time.perf_counter()
        views = [
            {name: pair[side].squeeze() for name, pair in scene.buffers.items()} for side in (0, 1)
        ]
        packing = PrincipalPacking.of_source(views[0])
        components, labels = zip(*(pack(packing, view) for view in views), strict=True)
        channels = [all_channels(view) for view in views]
        again = [part.copy() for part in (components[1], labels[1])]
        rows = []
        for name, guides, take in (
            ("all channels", channels, lambda: all_channels(views[1])),
            ("principal components", components, lambda: packing.pack_into(views[1], *again)),
        ):
            session = Session(seed=seed, threads=available_threads())
            session.set_exemplar(guides[0], scene.style, labels[0])
            session.set_target(guides[1], labels[1])
            energies = []
            for number in range(self.seeds):
                image = session.frame(seed=seed + number)
                energies.append(image_energy(scene, image).mean)
            every, nearest = rank_correlations(*channels, *guides)
            rows.append(
                {
                    "packing": name,
                    "bytes": guides[0].shape[2],
                    "all": every,
                    "nearest": nearest,
                    "pack": self._milliseconds(take),
                    "frame": self._milliseconds(session.frame),
                    "energy": np.mean(energies),
                }
            )
        return Outcome(image, time.perf_counter() - begun, history=pd.DataFrame(rows))

    def _milliseconds(self, work):
        spent = []
        with using_threads(available_threads()):
            for _ in range(self.rounds):
                before = time.perf_counter()
                work()
                spent.append(1000 * (time.perf_counter() - before))
        return float(np.median(spent))


def all_channels(view):
    """The bytes of all buffers side by side, (H, W, n) uint8."""
    return np.concatenate([np.atleast_3d(view[name]) for name in BUFFERS], axis=2)


def rank_correlations(source, target, packed_source, packed_target):
    """Of squared distances of pixels before and after packing.

    Parameters
    ----------
    source, target, packed_source, packed_target : (H, W, n) uint8

    Returns
    -------
    every, nearest : float
        Of all pairs of some pixels, and of the pairs with each target pixel's nearest 1 %.
    """
    rng = np.random.default_rng(0)
    some = rng.choice(source.shape[0] * source.shape[1], SOME, replace=False)
    there = rng.choice(target.shape[0] * target.shape[1], THERE, replace=False)
    before, after = (
        _distances(_flat(b)[there], _flat(a)[some])
        for a, b in ((source, target), (packed_source, packed_target))
    )
    near = np.argsort(before, axis=1, kind="stable")[:, :NEAREST]
    pairs = (np.take_along_axis(distances, near, axis=1).ravel() for distances in (before, after))
    return (
        float(spearmanr(before.ravel(), after.ravel())[0]),
        float(spearmanr(*pairs)[0]),
    )


def _flat(image):
    return image.reshape(-1, image.shape[2]).astype(np.int64)


def _distances(one, other):
    return ((one[:, None] - other) ** 2).sum(axis=2)


@dataclass(frozen=True)
class House:
    """The section on the house.

    Attributes
    ----------
    scene : Scene
    seeds : int
        Over which energies are means.
    """

    scene: Scene
    seeds: int

    @property
    def job(self):
        """Its run."""
        return Job(self.scene, Components(self.seeds))

    @property
    def tasks(self):
        """All runs."""
        return [Task(self.job, ())]

    def claims(self):
        """What we ask of ourselves."""
        found = stored(self.job).history.set_index("packing")
        ours, every = found.loc["principal components"], found.loc["all channels"]
        milliseconds = ours["pack"] * 500**2 / self.scene.pixels
        return [
            Claim(
                "Principal components keep what all channels tell",
                "ours",
                verdict(
                    ours["nearest"] >= LEAST_NEAREST
                    and milliseconds <= MOST_MILLISECONDS
                    and ours["energy"] <= MOST_ENERGY * every["energy"]
                ),
                f"rank correlation of the nearest pairs is at least {LEAST_NEAREST}, packing takes "
                f"at most {MOST_MILLISECONDS:g} ms for 500 x 500 pixels, and energy is at most "
                f"{MOST_ENERGY:g} times that of all channels",
                f"the correlation is {ours['nearest']:.3f}, packing takes {milliseconds:.2f} ms, "
                f"and energy is {ours['energy'] / every['energy']:.3f} times that of all channels",
                of_time=True,
            )
        ]

    def sections(self, report):
        """What the page says of it."""
        table = stored(self.job).history
        shown = table.round({"all": 4, "nearest": 3, "pack": 2, "frame": 1, "energy": 0})
        return [
            "### Principal components: the house",
            report.table("house", table, shown.astype(object).rename(columns=_TITLES)),
            f"A view of the house, {self.scene.size.replace('x', ' x ')} pixels, drawn in another "
            f"view; `best`. Rank correlation is that of squared distances of pixels with those of "
            f"all channels: of {SOME} pixels of the source with {THERE} of the target, and with "
            f"the nearest {NEAREST} of each. Times are medians of {ROUNDS} on all threads; energy "
            f"is {f'the mean over {self.seeds} seeds' if self.seeds > 1 else 'that of one seed'}.",
        ]


_TITLES = {
    "bytes": "bytes a pixel",
    "all": "rank correlation, all pairs",
    "nearest": "nearest pairs",
    "pack": "packing [ms]",
    "frame": "frame [ms]",
}
