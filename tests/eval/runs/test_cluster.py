"""Runs on a Dask cluster."""

import os
import signal

import pytest

import eval.runs.cluster
import eval.runs.complete
import eval.runs.local
import eval.runs.store
from eval.__main__ import main
from eval.documents.dzurenko.plan import preset
from eval.runs.complete import complete
from eval.runs.store import stored


@pytest.mark.slow
def test_a_cluster_survives_a_killed_worker(tmp_path, monkeypatch):
    """Two processes, one of which is killed at work."""
    from dask.distributed import Client, LocalCluster

    monkeypatch.chdir(tmp_path)
    plan = preset("quick", step=7, targets=["teapot"], seeds=[0])
    killed = []
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        keep = eval.runs.store.store

        def kill_one(job, result):
            keep(job, result)
            if not killed:
                with Client(cluster.scheduler_address) as client:
                    killed.extend(client.run(os.getpid).values())
                os.kill(killed[0], signal.SIGKILL)

        monkeypatch.setattr(eval.runs.complete, "store", kill_one)
        assert complete(plan.tasks, cluster.scheduler_address) == {}
    assert len(killed) == 2
    assert all(stored(job) is not None for job in plan.jobs)


@pytest.mark.slow
def test_a_scheduler_that_is_not_there_is_one_sentence(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("eval.runs.cluster.PATIENCE", "1s")
    assert main(["dzurenko", "--step", "6", "--scheduler", "tcp://127.0.0.1:9"]) == 2
    assert "--scheduler tcp://127.0.0.1:9 does not answer" in capsys.readouterr().err
