"""Read the motion of a frame from a file."""

from pathlib import Path

from stylit_ref.files.motion_file import read_vectors
from stylit_ref.views.motion.conventions import (
    AUTO,
    FrameMotion,
    convention_named,
    convention_of,
)


def read_motion(path: str | Path, convention: str = AUTO) -> FrameMotion:
    """Read the motion vectors of a frame as canonical fields.

    Parameters
    ----------
    path : str or Path
        ``.flo``, or an EXR of Blender, Nuke, this project or another program; ``file.exr:LAYER``
        names a layer.
    convention : str
        A name of :data:`stylit_ref.views.motion.conventions.CONVENTIONS`, or ``auto`` for what the
        names of file and channels tell.

    Returns
    -------
    FrameMotion

    Raises
    ------
    InputError
        If the file cannot be read, holds no vectors or vectors of another convention, or nothing
        tells its convention.
    """
    known = None if convention == AUTO else convention_named(convention)
    vectors = read_vectors(path)
    return (known or convention_of(vectors, str(path))).fields(vectors)
