"""How a number is shown."""

from typing import NamedTuple


class Number(NamedTuple):
    """Title and format of a number.

    Attributes
    ----------
    title : str
        Head of its column.
    form : str
        As for :meth:`str.format`.
    """

    title: str
    form: str
