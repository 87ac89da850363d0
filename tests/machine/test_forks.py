"""Kernels in processes that are forked before and after a first run."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = """
import multiprocessing, os, threading
from concurrent.futures import ProcessPoolExecutor
import numba, numpy as np
from small_scene import small_scene
from stylit_ref import Params, replay, stylize
from stylit_ref.stylization.problem import make_synthesis

PARAMS = Params(levels=2, votes=1, patchmatch_iterations=1)
fork = multiprocessing.get_context("fork")

def frame(seed=0, **options):
    return stylize(*small_scene(), PARAMS, seed=seed, **options).image.tobytes()

def threads(_=None):
    frame()
    return numba.get_num_threads()

def code_of(child):
    pid = os.fork()
    if pid == 0:
        os._exit(child())
    return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
"""


def succeeds(*lines):
    """Run the program and these lines in a process of their own that has two threads."""
    environment = {
        **os.environ,
        "PYTHONPATH": str(Path(__file__).parents[1]),
        "NUMBA_NUM_THREADS": "2",
        "NUMBA_THREADING_LAYER": "omp",
    }
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM + "\n".join(lines)],
        env=environment, capture_output=True, text=True, timeout=120,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    "pool", ["fork.Pool(2)", "ProcessPoolExecutor(2, mp_context=fork)"], ids=["Pool", "futures"]
)
def test_a_pool_after_a_run_returns_the_same_bytes(pool):
    succeeds(
        "expected = [frame(seed) for seed in range(4)]",
        f"with {pool} as pool:",
        "    assert list(pool.map(frame, range(4))) == expected",
    )


def test_a_child_has_one_thread_and_its_parent_keeps_all():
    succeeds(
        "assert threads() == 2",
        "assert code_of(threads) == 1",
        "assert threads() == 2",
    )


def test_a_child_forked_before_the_first_run_has_all_threads():
    succeeds("assert code_of(threads) == 2", "assert threads() == 2")


def test_a_child_of_a_child_works():
    succeeds("frame()", "assert code_of(lambda: code_of(threads)) == 1")


def test_another_thread_of_a_child_works():
    succeeds(
        "def in_a_thread():",
        "    found = []",
        "    thread = threading.Thread(target=lambda: found.append(threads()))",
        "    thread.start()",
        "    thread.join()",
        "    return found[0]",
        "frame()",
        "assert code_of(in_a_thread) == 1",
    )


def test_threads_that_a_child_lacks_are_not_asked_for():
    succeeds("expected = frame()", "assert code_of(lambda: frame(threads=2) == expected) == 1")


def test_a_child_that_leaves_a_run_keeps_one_thread():
    succeeds(
        "class Left(Exception): pass",
        "codes = []",
        "def leave(*_):",
        "    child = os.fork()",
        "    if child == 0: raise Left",
        "    codes.append(os.waitpid(child, 0)[1])",
        "try:",
        "    frame(threads=1, on_level=leave)",
        "except Left:",
        "    os._exit(threads() != 1)",
        "assert codes == [0, 0]",
    )


def test_a_run_that_was_set_up_in_the_parent():
    succeeds(
        "expected = frame()",
        "synthesis = make_synthesis(*small_scene(), PARAMS)",
        "assert code_of(lambda: synthesis.finish().style.tobytes() == expected) == 1",
    )


def test_replay_in_a_child():
    succeeds(
        "style, *guides = small_scene()",
        "result = stylize(style, *guides, PARAMS)",
        "assert code_of(lambda: (replay(result.nnf, style) == result.image).all()) == 1",
    )


def test_a_child_that_runs_no_kernel_is_not_disturbed():
    succeeds("frame()", "assert code_of(lambda: int(np.arange(10).sum())) == 45")
