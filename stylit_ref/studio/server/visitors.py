"""The pages that are open: one of them paints, the others look on."""

from collections.abc import Iterator
from secrets import token_urlsafe

from stylit_ref.studio.server.outbox import Outbox
from stylit_ref.studio.server.protocol import said

PAINTER, READER = "painter", "reader"


class Visitor:
    """A page.

    Attributes
    ----------
    outbox : Outbox
        What it is sent.
    name : str
        That nobody else knows.
    """

    def __init__(self) -> None:
        self.outbox: Outbox = Outbox()
        self.name: str = token_urlsafe(16)


class Visitors:
    """All pages.

    Attributes
    ----------
    painter : Visitor or None
        None when the one that painted has left; the next that comes may paint.
    """

    def __init__(self) -> None:
        self.painter: Visitor | None = None
        self._all: dict[Visitor, None] = {}  # in the order in which they came

    def __iter__(self) -> Iterator[Visitor]:
        return iter(self._all)

    def __contains__(self, visitor: object) -> bool:
        return visitor in self._all

    @property
    def readers(self) -> list[Visitor]:
        """All but the painter."""
        return [visitor for visitor in self._all if visitor is not self.painter]

    def role(self, visitor: Visitor) -> str:
        """What a page may do."""
        return PAINTER if visitor is self.painter else READER

    def join(self, visitor: Visitor) -> None:
        """Count a page in; it paints if no other does."""
        self._all[visitor] = None
        self.painter = self.painter or visitor

    def leave(self, visitor: Visitor) -> None:
        """Count a page out."""
        self._all.pop(visitor, None)
        if visitor is self.painter:
            self.painter = None
            self.say("notes", {"texts": ["Nobody paints now. Take over to paint here."]})

    def take_over(self, visitor: Visitor) -> None:
        """Have this page paint, and tell the one that did."""
        before, self.painter = self.painter, visitor
        for each in (before, visitor):
            if each is not None:
                each.outbox.say(said("role", {"role": self.role(each)}))

    def say(self, word: str, values: dict[str, object]) -> None:
        """Send a text to all."""
        text = said(word, values)
        for visitor in self._all:
            visitor.outbox.say(text)
