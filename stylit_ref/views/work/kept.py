"""Things that are kept in memory as long as there is room, and made again when there was none."""

from collections.abc import Callable, Hashable
from typing import Any, TypeVar

Value = TypeVar("Value")


class Kept:
    """A store of bounded size.

    When it is full, the largest entry goes, and of those of equal size the one used least recently.
    Coarse levels of many frames so outlive a few fine ones, which must be made again for every
    iteration in any case.

    Parameters
    ----------
    limit : int
        Bytes. The entry that was added last stays, however large it is.
    """

    def __init__(self, limit: int) -> None:
        self._limit, self._entries, self._total = limit, {}, 0

    def get(self, key: Hashable) -> Any:
        """The value of a key, or None."""
        if key not in self._entries:
            return None
        self._entries[key] = self._entries.pop(key)  # to the end
        return self._entries[key][0]

    def take(self, key: Hashable) -> Any:
        """The value of a key, which is not kept any more, or None."""
        return self._remove(key)

    def add(self, key: Hashable, value: Value, size: int) -> Value:
        """Keep a value of so many bytes, and return it."""
        self._remove(key)
        while self._entries and self._total + size > self._limit:
            self._remove(max(self._entries, key=lambda each: self._entries[each][1]))
        self._entries[key] = value, size
        self._total += size
        return value

    def forget(self, applies: Callable[[Any], bool]) -> None:
        """Remove the entries whose key something applies to."""
        for key in [key for key in self._entries if applies(key)]:
            self._remove(key)

    def _remove(self, key):
        value, size = self._entries.pop(key, (None, 0))
        self._total -= size
        return value
