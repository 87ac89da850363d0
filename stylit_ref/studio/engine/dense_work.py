"""What the process in the background does: one picture of the dense method after the other.

Nothing here runs beside the page: :mod:`stylit_ref.studio.engine.background` starts the process,
sends it a :class:`Job` at a time, and hears a :class:`Going`, a :class:`Kernels` and at last one of
the other messages. A shared number tells which job is wanted; a job that it does not name stops.
Before the first job it may be sent :class:`Ahead`.
"""

import logging
import os
import signal
from collections.abc import Sequence
from multiprocessing import parent_process
from multiprocessing.connection import Connection
from time import perf_counter
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.machine.threads import sleep_while_waiting

if TYPE_CHECKING:  # what takes a second is imported when the priority is low
    from stylit_ref.realtime.packing import Packing
    from stylit_ref.realtime.params import RealtimeParams
    from stylit_ref.stylization.params import Params

_NICENESS = 10
_BETWEEN_NEWS = 0.2  # seconds


class Job(NamedTuple):
    """A picture to make.

    Attributes
    ----------
    number : int
    style : (H_A, W_A, 3) uint8
    guides : pair of sequences of (H, W, n) uint8, or None
        Of source and target; None for those of the job before.
    params : Params
    seed : int
    """

    number: int
    style: NDArray[np.uint8]
    guides: tuple[Sequence[NDArray[np.uint8]], Sequence[NDArray[np.uint8]]] | None
    params: "Params"
    seed: int


class Ahead(NamedTuple):
    """Kernels of live frames to compile from the last on, while the page does from the first on.

    Attributes
    ----------
    params : RealtimeParams
    packing : Packing
    """

    params: "RealtimeParams"
    packing: "Packing"


class Kernels(NamedTuple):
    """A kernel is about to be compiled: its number, from 1, and how many there are."""

    number: int
    total: int


class Going(NamedTuple):
    """The share of the work that is done."""

    done: float


class Made(NamedTuple):
    """The picture, its NNF, and how long it took without compilation."""

    image: NDArray[np.uint8]
    nnf: NDArray[np.int32]
    milliseconds: float


class Stopped(NamedTuple):
    """There is no picture, since none is wanted."""


class Failed(NamedTuple):
    """Why there is no picture, in a sentence."""

    text: str


class _UnwantedError(Exception):
    pass


def work(connection: Connection, wanted: Any) -> None:
    """Do jobs until nobody sends any.

    Parameters
    ----------
    connection : multiprocessing.connection.Connection
    wanted : ctypes.c_uint64
        In shared memory: the number of the job that is wanted.
    """
    if hasattr(os, "nice"):
        os.nice(_NICENESS)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the program, which ends this
    sleep_while_waiting()
    logging.getLogger("stylit_ref").addHandler(logging.NullHandler())  # notes go to the program
    guides = None
    try:
        while True:
            job = connection.recv()
            if isinstance(job, Ahead):
                connection.send(_compiled(job))
            else:
                guides = job.guides or guides
                connection.send(_answer(job, guides, connection, wanted))
    except (EOFError, OSError):
        os._exit(0)  # at once: libraries would say at the end what they have not freed


def _compiled(ahead):
    from stylit_ref.machine.compilation import compile_missing
    from stylit_ref.realtime.warm_up import kernels_of_frame

    for kernel in reversed(kernels_of_frame(ahead.params, ahead.packing, warm=True)):
        compile_missing([kernel])
    return Stopped()


def _answer(job, guides, connection, wanted):
    from stylit_ref.stylization.stylize import stylize
    from stylit_ref.stylization.warm_up import warm_up

    last_news = perf_counter()

    def heed():
        if wanted.value != job.number or not parent_process().is_alive():
            raise _UnwantedError

    def compiling(number, total):  # what is compiled serves any other job too
        connection.send(Kernels(number, total))

    def progress(step):
        nonlocal last_news
        heed()
        if perf_counter() - last_news > _BETWEEN_NEWS:
            last_news = perf_counter()
            connection.send(Going(step.done))

    try:
        heed()
        channels = [guide.shape[2] for guide in guides[0]]
        warm_up(job.params, guide_channels=channels, progress=compiling)
        start = perf_counter()
        result = stylize(
            job.style, *guides, job.params, seed=job.seed, threads=1, progress=progress
        )  # fmt: skip
    except _UnwantedError:
        return Stopped()
    except InputError as error:
        return Failed(str(error))
    except MemoryError:
        return Failed("there is not enough memory for a picture of this size")
    return Made(result.image, result.nnf, 1000 * (perf_counter() - start))
