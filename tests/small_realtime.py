"""Small sources and targets with smooth guides, a noisy style and two labels."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.realtime.session import Session


class Case(NamedTuple):
    guides: NDArray[np.uint8]
    style: NDArray[np.uint8]
    labels: NDArray[np.uint8]
    target: NDArray[np.uint8]
    target_labels: NDArray[np.uint8]


def make_case(source=(40, 36), target=(37, 41), channels=10, seed=0):
    random = np.random.default_rng(seed)

    def smooth(height, width, phase):
        y, x = np.mgrid[:height, :width] / 9
        waves = [np.sin(y * (1 + c / 7) + x * (c % 3) + phase + c) for c in range(channels)]
        return np.uint8(127 + 100 * np.stack(waves, -1))

    guides, aimed = smooth(*source, 0), smooth(*target, 0.5)
    style = random.integers(0, 256, (*source, 3), np.uint8)
    labels, target_labels = np.zeros(source, np.uint8), np.zeros(target, np.uint8)
    labels[source[0] // 2 :], target_labels[target[0] // 3 :] = 3, 3
    if source[0] < 2:
        target_labels[:] = labels[0, 0]
    return Case(guides, style, labels, aimed, target_labels)


def make_session(case, params=None, with_labels=True, **options):
    session = Session(params, **{"seed": 5, "threads": 1} | options)
    session.set_exemplar(case.guides, case.style, case.labels if with_labels else None)
    session.set_target(case.target, case.target_labels if with_labels else None)
    return session
