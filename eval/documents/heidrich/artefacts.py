"""The artefacts of figures 24, 25 and 28 by name: which number tells of each, in which styles."""

from typing import NamedTuple

from eval.documents.heidrich.plan import STYLES


class Artefact(NamedTuple):
    """An artefact and the number that measures it.

    Attributes
    ----------
    name, section : str
    number : str
        One of :data:`eval.metrics.NUMBERS`.
    sign : {1, -1}
        1 if more of the number is worse, else -1.
    styles : tuple of str
        Those that can show it.
    least : float
        Nothing shows below it.
    """

    name: str
    section: str
    number: str
    sign: int = 1
    styles: tuple[str, ...] = STYLES
    least: float = 0.0


ARTEFACTS = (
    Artefact("The background is not continued", "6.2.1, 24a", "spilled"),
    Artefact("Hatching is broken", "6.2.1, 24b", "hatching", -1, ("pen",)),
    Artefact("Foreground appears in the background", "6.2.1, 24c", "foreground_outside"),
    Artefact("The style's border is visible", "6.2.1, 24d", "style_border", least=2.0),
    Artefact("Thin lines run along silhouettes", "6.2.1, 25a g n", "silhouette_lines"),
    Artefact("Structures are stretched or squeezed", "6.2.1, 25e j l m", "stretched"),
    Artefact("Straight strokes come out bent", "6.2.2", "bent"),
    Artefact("Highlights are lost", "6.3, 28a", "lost_highlights"),
)
