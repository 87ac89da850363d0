"""What the engine tells: pictures, and how the work goes on."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Which = Literal["replay", "coherent", "warm", "fast", "full", "step", "look"]
"""What a picture is.

``replay`` is blended from the matches of the frame before; ``coherent`` is a cold frame with the
same seed, so that little changes beside the stroke; ``warm`` starts from the frame before; ``fast``
and ``full`` are those of the dense method; ``step`` is a frame on its way; ``look`` is whatever was
asked for.
"""

State = Literal["started", "cancelled", "done", "failed"]


@dataclass(frozen=True, eq=False)
class Picture:
    """A picture to show.

    Attributes
    ----------
    which : str
    image : (H, W, 3) uint8
    serial : int
        Of the last change of the painting that it shows.
    milliseconds : float
        How long it took.
    of : str
        Of a look: what was asked for.
    """

    which: Which
    image: NDArray[np.uint8]
    serial: int
    milliseconds: float
    of: str = ""


@dataclass(frozen=True)
class Working:
    """How the work in the background goes on: on ``fast`` or on ``full``.

    Attributes
    ----------
    which : str
    state : str
        ``started`` comes again and again, with a text that says how far it is.
    text : str
    """

    which: Which
    state: State
    text: str


@dataclass(frozen=True)
class Compiling:
    """Kernels are compiled, which happens once for each machine.

    Attributes
    ----------
    text : str
    done, total : int
        Kernels; they are equal when no more is compiled.
    """

    text: str
    done: int
    total: int


@dataclass(frozen=True)
class Problem:
    """Something cannot be done.

    Attributes
    ----------
    text : str
        A sentence for the user.
    of : str
        What was asked for, if it was a look.
    """

    text: str
    of: str = ""


@dataclass(frozen=True)
class Stepped:
    """How far a frame has come that is made step by step.

    Attributes
    ----------
    level : int
        0 is the finest.
    iteration : int
        Iterations of the level that are done.
    done : bool
        Whether the frame is finished.
    possible : tuple of str
        What may follow.
    """

    level: int
    iteration: int
    done: bool
    possible: tuple[str, ...]


@dataclass(frozen=True)
class Exported:
    """Files were written.

    Attributes
    ----------
    folder : str
    files : tuple of str
        Their names in the folder.
    commands : tuple of str
        Command lines, each of which gives the bytes of the picture.
    """

    folder: str
    files: tuple[str, ...]
    commands: tuple[str, ...]


Event = Picture | Working | Compiling | Problem | Stepped | Exported
