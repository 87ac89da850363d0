"""The files that tell what views show, for views between them: a mesh, or positions."""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np

from stylit_ref.cli.motion_files import read_ids
from stylit_ref.cli.shot_problems import ShotProblems
from stylit_ref.errors import InputError
from stylit_ref.files.mesh_file import read_obj
from stylit_ref.files.picture import read_picture
from stylit_ref.views.interpolation.camera import read_camera
from stylit_ref.views.interpolation.projection import check_positions
from stylit_ref.views.mesh import Mesh, make_mesh
from stylit_ref.views.positions import Positions


class SceneFiles(NamedTuple):
    """A mesh, or the positions of every frame's points.

    Attributes
    ----------
    mesh : str or None
        An ``.obj`` file.
    positions : sequence of str
        Of every frame; empty if there are none.
    ids : sequence of str
        Of every frame; empty if there are none.
    """

    mesh: str | None = None
    positions: Sequence[str] = ()
    ids: Sequence[str] = ()

    @property
    def files(self) -> list[str]:
        """Those of the scene; IDs belong to the motion."""
        return [*([self.mesh] if self.mesh else []), *self.positions]

    def read_mesh(self) -> Mesh | None:
        """Read the mesh, and join what forms a face.

        Raises
        ------
        InputError
            If it cannot be read, or is no mesh.
        """
        if self.mesh is None:
            return None
        try:
            return make_mesh(*read_obj(self.mesh))
        except InputError as error:
            if str(error).startswith(self.mesh):
                raise
            raise InputError(f"{self.mesh}: {error}") from None

    def read_positions(self, frame: int) -> Positions:
        """Read the positions of a frame; its IDs say what belongs to what.

        Raises
        ------
        InputError
            If a file cannot be read, or holds no positions.
        """
        file = self.positions[frame]
        points = read_picture(file, is_guide=True).colours
        if points.dtype != np.float32 or points.shape[2] != 3:
            raise InputError(
                f"{file}: has {points.shape[2]} channels of {points.dtype}; positions are three of "
                "floating point"
            )
        labels = np.zeros(points.shape[:2], np.int32)
        is_there = np.isfinite(points).all(axis=2)
        if self.ids:
            ids = read_ids(self.ids[frame])
            if ids.shape != labels.shape:
                raise InputError(
                    f"{self.ids[frame]}: is {ids.shape[1]}x{ids.shape[0]} but {file} is "
                    f"{labels.shape[1]}x{labels.shape[0]}; render both at one size"
                )
            is_there &= ids != 0
            labels = np.unique(ids, return_inverse=True)[1].reshape(ids.shape).astype(np.int32)
        else:
            is_there &= points.any(axis=2)  # renderers write 0 where nothing is
        labels = np.where(is_there, labels, -1)
        return Positions(np.where(is_there[:, :, None], points, 0).astype(np.float32), labels)


def check_positions_files(
    scene: SceneFiles,
    names: Sequence[str],
    cameras: Sequence[Mapping[str, Any]] | None,
    size: tuple[int, int],
    problems: ShotProblems,
) -> None:
    """Read the positions of all frames, and compare them with what their cameras see.

    Parameters
    ----------
    scene : SceneFiles
    names : sequence of str
        Of the frames.
    cameras : sequence of mapping, optional
        What is known of the camera of every frame.
    size : tuple of 2 int
        Rows and columns of the frames.
    problems : ShotProblems
        Is told what cannot be read, or does not fit.
    """
    for frame, file in enumerate(scene.positions):
        camera = read_camera(cameras[frame], names[frame]) if cameras else None
        try:
            positions = scene.read_positions(frame)
        except InputError as error:
            problems.add(error.sentence, file)
            continue
        try:
            check_positions(positions, camera, size, names[frame])
        except InputError as error:
            problems.add(f"{file}: {error.sentence}", file)
