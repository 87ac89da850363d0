"""Motion over several frames, from that between neighbouring ones."""

from stylit_ref.views.frames import Motion
from stylit_ref.views.motion.places import fetched, places_in_other


def composed(first: Motion, second: Motion) -> Motion:
    """Follow one motion, then another.

    The second is taken at the pixel that the first leads to, and not between pixels: a mean over an
    edge in depth would belong to neither side.

    Parameters
    ----------
    first : Motion
        From this frame into the one between.
    second : Motion
        From there into the last.

    Returns
    -------
    Motion
        From this frame into the last; hidden where either is.
    """
    places = places_in_other(first)
    shown = (places[:, :, 0] >= 0) & fetched(second.visible, places)
    return Motion(first.field + fetched(second.field, places), shown)
