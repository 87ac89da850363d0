"""Times of iterations, and what two threads can gain, on a texture of few pixels."""

from types import SimpleNamespace

import numpy as np
import pandas as pd
import pytest

from eval.documents.lasram.timing import REPEATS, THREADS, Ceiling, ThreadTimes, ceiling, timing
from eval.runs.job import Job
from eval.runs.local import run
from eval.textures import Texture


@pytest.fixture
def exemplar(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    return np.random.default_rng(1).integers(0, 256, (24, 24, 1), dtype=np.uint8)


def test_every_shape_has_a_row_of_times(exemplar):
    jobs = [
        Job(Texture("grey", exemplar, (side, side)), ThreadTimes(radius))
        for side, radius in ((16, 4), (20, 5))
    ]
    history, _ = (run(job).history for job in jobs)
    assert len(history) == REPEATS * len(THREADS) * history["iteration"].max()
    times = timing(jobs)
    assert times["size of S"].tolist() == [16, 20]
    assert times["R"].tolist() == [4, 5]
    assert (times.filter(like="[ms]") > 0).all(axis=None)


def test_times_are_medians_of_mean_iterations(exemplar, monkeypatch):
    job = Job(Texture("grey", exemplar, (16, 16)), ThreadTimes(4))
    rows = [
        {"threads": threads, "repeat": k, "iteration": n, "milliseconds": mean + mean * (n > 10)}
        for threads, means in ((1, (4, 8, 5)), (2, (2, 1, 9)))
        for k, mean in enumerate(means)
        for n in range(1, 17)
    ]
    monkeypatch.setattr(
        "eval.documents.lasram.timing.stored", lambda _: SimpleNamespace(history=pd.DataFrame(rows))
    )
    (row,) = timing([job]).to_dict("records")
    assert row["1 thread, 11 to 16 [ms]"] == 10
    assert row["2 threads, 11 to 16 [ms]"] == 4
    assert row["1 thread, 1 to 16 [ms]"] == pytest.approx(5 * (10 + 2 * 6) / 16, abs=0.01)
    assert row["times as fast"] == 2.5


def test_the_ceiling_is_that_of_memory_and_of_arithmetic(exemplar):
    job = Job(Texture("grey", exemplar, (16, 16)), Ceiling())
    run(job)
    possible = ceiling(job)
    assert possible["work"].tolist() == ["a plain copy of 64 MB", "arithmetic alone"]
    ratio = possible["1 thread [ms]"] / possible["2 threads [ms]"]
    np.testing.assert_allclose(possible["times as fast"], ratio, rtol=0.05)
