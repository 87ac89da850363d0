"""A shot on a Dask cluster."""

import os
import signal

import numpy as np
import pytest
from small_shot import EFFORT, sliding

from stylit_ref import Coherence, InputError, Params, stylize_views

PARAMS = Params(**EFFORT)


def run(order, **others):
    style, sources, guides, edges = sliding()
    coherence = Coherence(order=order)
    results = stylize_views(style, sources, guides, PARAMS, coherence, edges=edges, **others)
    return sorted(results, key=lambda result: result.frame)


@pytest.mark.slow
def test_a_cluster_gives_the_same_bytes_although_a_process_is_killed(tmp_path):
    from dask.distributed import Client, LocalCluster

    killed = []
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        address = cluster.scheduler_address

        def kill_one(step):
            if not killed and step.level == 2:
                with Client(address) as client:
                    killed.extend(client.run(os.getpid).values())
                os.kill(killed[0], signal.SIGKILL)

        for order in ("parallel", "sequential"):
            killed.clear()
            work = tmp_path / order
            found = run(order, work=work, scheduler=address, threads=1, progress=kill_one)
            assert killed
            for one, other in zip(found, run(order), strict=True):
                assert np.array_equal(one.image, other.image)
                assert np.array_equal(one.nnf, other.nnf)


def test_a_scheduler_that_is_not_there_is_one_sentence(tmp_path, monkeypatch):
    monkeypatch.setattr("stylit_ref.views.work.distributed.PATIENCE", "1s")
    with pytest.raises(InputError, match=r"scheduler tcp://127.0.0.1:9 does not answer"):
        run("parallel", work=tmp_path, scheduler="tcp://127.0.0.1:9")


def test_a_cluster_needs_a_folder_that_all_know():
    with pytest.raises(InputError, match="work is missing; with a scheduler name a folder"):
        run("parallel", scheduler="tcp://127.0.0.1:9")


@pytest.mark.slow
def test_a_scheduler_without_workers_is_one_sentence(tmp_path, monkeypatch):
    from dask.distributed import LocalCluster

    monkeypatch.setattr("stylit_ref.views.work.distributed.PATIENCE", "1s")
    with (
        LocalCluster(n_workers=0, dashboard_address=None) as cluster,
        pytest.raises(InputError, match=r"has no workers; start some with 'dask worker tcp://"),
    ):
        run("parallel", work=tmp_path, scheduler=cluster.scheduler_address)
