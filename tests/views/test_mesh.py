"""Which triangles form one face."""

import numpy as np
import pytest
from small_run import box_on_ground

from stylit_ref import InputError
from stylit_ref.views.mesh import make_mesh

SQUARES = np.float32([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 2, 0], [1, 2, 0]])
STRIP = np.array([[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 5, 4]])


def bent(degrees):
    """The strip, its second square turned about the edge between them."""
    vertices, angle = SQUARES.copy(), np.radians(degrees)
    vertices[4:, 1:] = 1 + np.cos(angle), np.sin(angle)
    return vertices


def test_sides_of_a_box_are_faces_of_their_own():
    assert box_on_ground().groups.tolist() == [k // 2 for k in range(14)]


@pytest.mark.parametrize(("degrees", "faces"), [(0, 1), (25, 1), (35, 2), (90, 2)])
def test_what_meets_smoothly_is_one_face(degrees, faces):
    assert len(set(make_mesh(bent(degrees), STRIP).groups.tolist())) == faces


def test_corners_at_one_place_meet_whichever_way_they_run():
    apart = SQUARES[STRIP].reshape(-1, 3)
    faces = np.arange(12).reshape(-1, 3)
    faces[1] = faces[1, ::-1]
    assert set(make_mesh(apart, faces).groups.tolist()) == {0}


def test_parts_do_not_join():
    assert make_mesh(SQUARES, STRIP, np.array([0, 0, 1, 1])).groups.tolist() == [0, 0, 1, 1]


@pytest.mark.parametrize(
    ("vertices", "faces", "said"),
    [
        (SQUARES, STRIP[:0], "holds no faces; export the scene with its faces"),
        (SQUARES * np.float32("nan"), STRIP, "holds a vertex that is no finite number"),
        (SQUARES, STRIP + 3, "holds a face with the vertex 8, and there are 6; export"),
    ],
)
def test_what_is_no_mesh(vertices, faces, said):
    with pytest.raises(InputError, match=said):
        make_mesh(vertices, faces)


def test_far_away_vertices_keep_their_bits_and_close_ones_do_not():
    far = SQUARES.astype(np.float64) + 5e6  # 5000 km away, in metres
    assert make_mesh(far, STRIP).vertices.dtype == np.float64
    np.testing.assert_array_equal(make_mesh(far, STRIP).vertices, far)
    assert make_mesh(SQUARES.astype(np.float64) + 5, STRIP).vertices.dtype == np.float32
