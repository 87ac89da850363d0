"""The title and format in which a number is shown."""

from typing import NamedTuple


class Number(NamedTuple):
    """Title and format of a number.

    Attributes
    ----------
    title : str
        Title of its column.
    form : str
        Format string for :meth:`str.format`.
    """

    title: str
    form: str
