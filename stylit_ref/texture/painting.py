"""Paint a texture with an exemplar (section 8, "Texture brush")."""

import numpy as np
from numpy.typing import NDArray

from stylit_ref.parameters import Integer
from stylit_ref.randomness.random_stream import WHITE_NOISE
from stylit_ref.texture.beginning import noise_of
from stylit_ref.texture.checks import check_exemplar, check_lock
from stylit_ref.texture.iteration import Iteration
from stylit_ref.texture.passes.layout import LOCKED
from stylit_ref.texture.session import TextureSession

_ITERATIONS = Integer(1, 1 << 30)


def paint(
    session: TextureSession, mask: NDArray[np.bool_], exemplar: int, iterations: int = 4
) -> list[Iteration]:
    """Paint with an exemplar: what is white becomes a hole, and is filled at once.

    The cost may rise; all other pixels stay as they are. A session with labels remembers the new
    ones.

    Parameters
    ----------
    session : TextureSession
        Patches are of the radius of its next iterations.
    mask : (height, width) bool
        Where the brush was. Locked pixels are left out.
    exemplar : int
        Its number, from 1.
    iterations : int
        How many to do at once, at least 1.

    Returns
    -------
    list of Iteration

    Raises
    ------
    InputError
        If the mask has another size, there is no such exemplar, or no iteration.
    """
    iterations = _ITERATIONS.check("iterations", iterations)
    texture = session.texture
    brushed = check_lock(mask, session.size, "mask") & ~texture.lock & LOCKED
    label = check_exemplar(exemplar, session.exemplars.images)
    painted = np.flatnonzero(brushed)
    if not painted.size:
        return []
    noise = noise_of(session.exemplars, label, painted.size, session.stream(WHITE_NOISE))
    texture.addresses.ravel()[painted] = noise
    if session.canvas.has_labels:
        texture.labels.ravel()[painted] = label
    with session.working_on(session.canvas.only(brushed)):
        return [session.step() for _ in range(iterations)]
