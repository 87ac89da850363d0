"""Parts of the page that a studio may have or not."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from starlette.routing import BaseRoute


class Panel(NamedTuple):
    """A part of the page, and what it asks the server for.

    Attributes
    ----------
    name : str
        By which the page knows it.
    routes : sequence of BaseRoute
    close : callable
        Gives up what is being made, when the studio ends.
    """

    name: str
    routes: Sequence[BaseRoute]
    close: Callable[[], None] = lambda: None
