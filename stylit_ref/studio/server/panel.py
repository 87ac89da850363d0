"""Parts of the page that a studio may have or not."""

from collections.abc import Sequence
from typing import NamedTuple

from starlette.routing import BaseRoute


class Panel(NamedTuple):
    """A part of the page, and what it asks the server for.

    Attributes
    ----------
    name : str
        By which the page knows it.
    routes : sequence of BaseRoute
    """

    name: str
    routes: Sequence[BaseRoute]
