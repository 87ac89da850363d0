"""Meshes of other programs."""

import numpy as np
import pytest

from data_gen.models.mesh import polygons, to_obj
from stylit_ref import InputError
from stylit_ref.files.mesh_file import read_obj

TEXT = """# of another program
mtllib scene.mtl
o wall
v 0 0 0
v 1.5 0 0 1 0 0
v 1 1 -2e-1
v 0 1 0
vn 0 0 1
vt 0 0
usemtl plaster
f 1/1/1 2/1/1 3//1 4
s off
usemtl brick
f -4 -2 -1
"""


def test_polygons_become_triangles_and_materials_parts(tmp_path):
    (tmp_path / "scene.obj").write_text(TEXT)
    vertices, faces, parts = read_obj(tmp_path / "scene.obj")
    np.testing.assert_array_equal(vertices, [[0, 0, 0], [1.5, 0, 0], [1, 1, -0.2], [0, 1, 0]])
    assert faces.tolist() == [[0, 1, 2], [0, 2, 3], [0, 2, 3]]
    assert parts.tolist() == [0, 0, 1]


def test_meshes_of_made_scenes_come_back(tmp_path):
    made = {
        name: polygons([np.random.default_rng(k).random((4, 3))])
        for k, name in enumerate(("walls", "roof"))
    }
    (tmp_path / "scene.obj").write_text(to_obj(made))
    vertices, faces, parts = read_obj(tmp_path / "scene.obj")
    np.testing.assert_array_equal(vertices, np.concatenate([m.vertices for m in made.values()]))
    assert faces.tolist() == [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]]
    assert parts.tolist() == [0, 0, 1, 1]


@pytest.mark.parametrize("line", ["v 1 2", "v 1 two 3", "f 1 2 9", "f 1 0 2", "f 1 2 -8"])
def test_a_broken_line_is_named(tmp_path, line):
    (tmp_path / "scene.obj").write_text(f"v 0 0 0\nv 1 0 0\n{line}\n")
    with pytest.raises(InputError, match=r"scene.obj: its line 3 is broken: '[vf] "):
        read_obj(tmp_path / "scene.obj")


def test_a_file_that_is_not_there(tmp_path):
    with pytest.raises(InputError, match=r"scene.obj: no such file"):
        read_obj(tmp_path / "scene.obj")
