"""Frame numbers as people write them: ``1-100x2,120``."""

from collections.abc import Iterable

from fileseq import FrameSet, framesToFrameRange
from fileseq.exceptions import MaxSizeException, ParseException

from stylit_ref.errors import InputError


def frames_of(text: str) -> tuple[int, ...]:
    """The frames of a range, in ascending order and each once.

    Parameters
    ----------
    text : str
        Numbers and ranges with commas between them; ``1-9x2`` is every second frame.

    Returns
    -------
    tuple of int

    Raises
    ------
    InputError
        If it is no range, or too long.
    """
    described = "numbers and ranges, such as 1-100, 1-100x2 or 1-50,60"
    try:
        if len(text.split()) > 1:  # the library takes "1-5 7" for 1 to 57
            raise ParseException
        found = set(FrameSet(text))
    except MaxSizeException:
        raise InputError(f"is {text!r}, which are too many frames", parameter="frames") from None
    except ParseException:
        found = set()
    if not found or any(frame != int(frame) for frame in found):
        raise InputError(f"is {text!r}; it must be {described}", parameter="frames")
    return tuple(sorted(map(int, found)))


def range_text(frames: Iterable[int]) -> str:
    """The shortest text for some frames: ``1-7x2,120``."""
    return framesToFrameRange(frames, sort=True)
