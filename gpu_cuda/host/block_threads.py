"""How Numba's simulator runs the threads of a block.

Its own way is a thread of Python for each of them, all at once, which it asks in a loop whether
they are done. Here one follows another, which takes a third of the time. Their order is shuffled,
the same way in each process: a kernel whose result depends on it is likely to be found out.
"""

import random
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from threading import Semaphore

import numpy as np
from numba.cuda.simulator import kernel as simulator
from numba.cuda.simulator.kernelapi import Dim3


@contextmanager
def one_after_another() -> Iterator[None]:
    """Let kernels that are launched in the block run their threads so."""
    own = simulator.BlockManager
    simulator.BlockManager = _Block
    try:
        yield
    finally:
        simulator.BlockManager = own


class _Block:
    """A block of threads, with the interface of the simulator's own."""

    def __init__(self, kernel, grid_dim, block_dim, debug):
        self.block_state = np.zeros(block_dim, np.bool_)  # where threads count, at a barrier
        self._kernel, self._block_dim = kernel, block_dim
        self._turn = Semaphore(0)

    def run(self, grid_point, *arguments):
        places = list(np.ndindex(*self._block_dim))
        random.Random(repr(grid_point)).shuffle(places)
        call, workers = partial(self._kernel, *arguments), []
        try:
            self._run(partial(_Worker, self, grid_point, iter(places), call), workers)
        finally:  # a thread has failed, or somebody interrupts, or all are done
            for worker in workers:
                worker.abort = True
                worker.goes_on.release()
                worker.join()

    def _run(self, make_worker, workers):
        waiting = []
        while not workers or waiting[-1:] == workers[-1:]:  # the last one waits at a barrier
            workers.append(make_worker())
            workers[-1].start()
            waiting += self._waited_for(workers[-1])
        while waiting:
            now, waiting = waiting, []
            for worker in now:
                worker.goes_on.release()
                waiting += self._waited_for(worker)

    def _waited_for(self, worker):
        """The worker, once it has come to a barrier; nothing, once it has come to the end."""
        self._turn.acquire()
        if worker.exception is not None:
            raise worker.exception
        return [] if worker.is_done else [worker]


class _Worker(simulator.BlockThread):
    """A thread of Python that runs one thread after another, until one waits at a barrier.

    Those that are left are then another worker's.
    """

    def __init__(self, block, grid_point, places, call):
        super().__init__(call, block, grid_point, (0, 0, 0), False)
        self.goes_on, self.is_done = Semaphore(0), False
        self._places, self._call = places, call

    def run(self):
        try:
            for place in self._places:
                if self.abort:
                    break
                self.threadIdx = Dim3(*place)  # what a kernel asks its thread of Python for
                self.thread_id = np.ravel_multi_index(place[::-1], self._manager._block_dim[::-1])
                self._call()
        except BaseException as error:
            error.add_note(f"in the thread {tuple(self.threadIdx)} of the block {self.blockIdx}")
            self.exception = error
        self.is_done = True
        self._manager._turn.release()

    def syncthreads(self):
        self._manager._turn.release()
        self.goes_on.acquire()
        if self.abort:
            raise RuntimeError("the kernel has been given up")
