"""What the engine tells, as messages for the pages."""

from dataclasses import asdict

from stylit_ref.studio.engine.events import (
    Compiling,
    Event,
    Exported,
    Picture,
    Problem,
    Stepped,
    Working,
)
from stylit_ref.studio.server.protocol import said, sentence
from stylit_ref.studio.server.sent_picture import SentPicture
from stylit_ref.studio.server.visitors import Visitor, Visitors

_WORDS = {
    Working: "working", Compiling: "compiling", Problem: "problem", Stepped: "stepped",
    Exported: "exported",
}  # fmt: skip

_ASKED_FOR = "look", "step"
"""Pictures for the painter alone."""


class Telling:
    """Passes events on, and tells a page that comes later the last of them.

    Parameters
    ----------
    visitors : Visitors
    """

    def __init__(self, visitors: Visitors) -> None:
        self._visitors = visitors
        self._last: dict[str, SentPicture] = {}
        self._compiling: str | None = None
        self._problem: str | None = None  # since the last picture

    def pass_on(self, event: Event) -> None:
        """Send an event to whom it may concern."""
        if isinstance(event, Picture):
            self._show(event)
            return
        values = asdict(event)
        if isinstance(event, Problem):
            values["text"] = sentence(event.text)
        text = said(_WORDS[type(event)], values)
        if isinstance(event, Problem):
            self._problem = text
        if isinstance(event, Compiling):
            self._compiling = text if event.done < event.total else None
        for visitor in self._visitors:
            visitor.outbox.say(text)

    def catch_up(self, visitor: Visitor) -> None:
        """Send a page what it has missed."""
        if self._compiling:
            visitor.outbox.say(self._compiling)
        if self._problem:
            visitor.outbox.say(self._problem)
        for kind, picture in self._last.items():
            visitor.outbox.show(kind, picture)

    def _show(self, event: Picture) -> None:
        picture = SentPicture(event)
        if event.which in _ASKED_FOR:
            if self._visitors.painter:
                self._visitors.painter.outbox.show(f"{event.which} {event.of}", picture)
            return
        self._last, self._problem = {"picture": picture}, None
        for visitor in self._visitors:
            visitor.outbox.show("picture", picture)
