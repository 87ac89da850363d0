"""The time of a frame, of several methods in turns."""

import time
from dataclasses import dataclass

import numpy as np
import pandas as pd

from eval.on_processor import OnProcessor
from eval.outcome import Outcome
from stylit_ref.machine.forks import available_threads


@dataclass(frozen=True)
class FrameTimes(OnProcessor):
    """Cold frames from the caller's buffers to a picture, packing included, kernels compiled.

    Methods take turns, so that what else the machine does falls on all of them. Each frame is made
    on one thread, where the time of the processor is that of the work alone.

    Attributes
    ----------
    name : str
        What is compared.
    methods : tuple of Realtime or Hybrid
    rounds : int
        The history has the median of so many, methods in turns.
    on_all : bool
        Whether frames are made on all threads too.
    """

    name: str
    methods: tuple
    rounds: int
    on_all: bool = False

    cost = 10.0

    @property
    def code(self):
        """Digest of this file and of the methods, which it does not import."""
        return " ".join([super().code, *(method.code for method in self.methods)])

    @property
    def alone(self):
        """Whether nothing else may run: frames on all threads are timed by the clock."""
        return self.on_all

    def run(self, scene, seed, progress=None):
        """Make the frames.

        Parameters
        ----------
        scene : Scene
        seed : int
        progress : callable, optional
            Not called.

        Returns
        -------
        Outcome
            The history has a row for each method: ``method``, ``cpu`` in milliseconds on one
            thread, and with :attr:`on_all` ``wall`` in milliseconds on all. The image is the last
            one's.
        """
        times = pd.DataFrame({"method": [method.name for method in self.methods]})
        begun = time.perf_counter()
        columns = [("cpu", 1, time.process_time)]
        if self.on_all:
            columns.append(("wall", available_threads(), time.perf_counter))
        for column, threads, clock in columns:
            makers = [method.frames(scene, seed, threads) for method in self.methods]
            spent = np.full((self.rounds + 1, len(makers)), np.inf)
            for turn in spent:
                for number, maker in enumerate(makers):
                    before = clock()
                    image = maker.frame()
                    turn[number] = 1000 * (clock() - before)
            times[column] = np.median(spent[1:], axis=0)  # the first turn compiles
        return Outcome(image, time.perf_counter() - begun, history=times)
