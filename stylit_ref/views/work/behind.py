"""Work that waits for the disk, done behind the caller's back."""

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from types import TracebackType
from typing import ParamSpec

Arguments = ParamSpec("Arguments")


class Behind:
    """Does one thing at a time in a thread of its own, while the caller goes on.

    What is done there must call no kernel: those of two threads would fight for the processor. Use
    it in a ``with`` block, whose end waits for what is left.
    """

    def __init__(self) -> None:
        self._thread = ThreadPoolExecutor(max_workers=1)
        self._begun: Future[None] | None = None

    def do(
        self, work: Callable[Arguments, None], *args: Arguments.args, **kwargs: Arguments.kwargs
    ) -> None:
        """Begin something, when all that was begun before is done; what that raised is raised."""
        self.wait()
        self._begun = self._thread.submit(work, *args, **kwargs)

    def wait(self) -> None:
        """Wait until all that was begun is done; what it raised is raised."""
        begun, self._begun = self._begun, None
        if begun:
            begun.result()

    def __enter__(self) -> "Behind":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        with self._thread:
            self.wait()
