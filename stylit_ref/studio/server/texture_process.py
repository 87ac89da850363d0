"""A texture in a process of its own: painting waits neither for it nor for its compiler."""

import multiprocessing
import os
import signal
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from threading import Lock

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.studio.server.dropped_texture import DroppedTexture

_Drop = tuple[tuple[int, int], tuple[int, int], bool]

_NICENESS = 10


class TextureProcess:
    """As :class:`DroppedTexture`; the process begins when somebody asks for the texture.

    Parameters
    ----------
    exemplar : (H, W, 3) uint8

    Attributes
    ----------
    exemplar : (H, W, 3) uint8
    """

    def __init__(self, exemplar: NDArray[np.uint8]) -> None:
        self.exemplar: NDArray[np.uint8] = exemplar
        self._turn = Lock()
        self._process: BaseProcess | None = None
        self._connection: Connection | None = None

    def picture(self) -> NDArray[np.uint8]:
        """The texture as it is now, (side, side, 3) uint8.

        Raises
        ------
        InputError
            If the process has ended.
        """
        return self._ask(None)

    def dropped(
        self, source: tuple[int, int], place: tuple[int, int], *, keep: bool
    ) -> NDArray[np.uint8]:
        """The texture with a patch on it; parameters are those of :meth:`DroppedTexture.dropped`.

        Raises
        ------
        InputError
            If a place is none, or the process has ended.
        """
        return self._ask((source, place, keep))

    def close(self) -> None:
        """End the process."""
        if self._process:
            self._process.kill()

    def _ask(self, drop: _Drop | None) -> NDArray[np.uint8]:
        with self._turn:
            connection = self._connection or self._begun()
            try:
                connection.send(drop)
                answer = connection.recv()
            except (EOFError, OSError):
                self._connection = None
                raise InputError("the texture is lost; begin another one") from None
        if isinstance(answer, str):
            raise InputError(answer)
        return answer

    def _begun(self):
        context = multiprocessing.get_context("spawn")
        self._connection, theirs = context.Pipe()
        self._process = context.Process(target=_work, args=(theirs, self.exemplar), daemon=True)
        self._process.start()
        theirs.close()
        return self._connection


def _work(connection: Connection, exemplar: NDArray[np.uint8]) -> None:
    """What the process does until nobody asks any more."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the studio, which ends this
    if hasattr(os, "nice"):
        os.nice(_NICENESS)
    texture = DroppedTexture(exemplar)
    try:
        while True:
            drop: _Drop | None = connection.recv()
            try:
                answer = _answer(texture, drop)
            except InputError as error:
                answer = str(error)
            connection.send(answer)
    except (EOFError, OSError):
        return


def _answer(texture: DroppedTexture, drop: _Drop | None) -> NDArray[np.uint8]:
    if drop is None:
        return texture.picture()
    source, place, keep = drop
    return texture.dropped(source, place, keep=keep)
