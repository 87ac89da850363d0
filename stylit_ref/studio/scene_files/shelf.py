"""The scenes of a studio."""

from collections.abc import Iterator, Sequence

from stylit_ref.errors import InputError
from stylit_ref.studio.scene_files.offer import Offer


class Shelf:
    """Offers by name.

    Parameters
    ----------
    offers : sequence of Offer
        At least one, each with a name of its own.
    """

    def __init__(self, offers: Sequence[Offer]) -> None:
        self._offers = {offer.name: offer for offer in offers}

    def __iter__(self) -> Iterator[Offer]:
        return iter(self._offers.values())

    @property
    def first(self) -> Offer:
        """What a studio begins with."""
        return next(iter(self))

    def offer(self, name: str) -> Offer:
        """A scene by its name.

        Raises
        ------
        InputError
            If there is none.
        """
        if name not in self._offers:
            raise InputError(f"there is no scene {name[:40]!r}")
        return self._offers[name]
