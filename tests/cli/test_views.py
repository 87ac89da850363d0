"""``stylit-ref views`` from end to end, and its manifest."""

import json

import numpy as np
import pytest
from cli.calls import QUICK, refused

from stylit_ref import Coherence, Motion, Params, Run, read_image, stylize_views, write_image
from stylit_ref.cli import main
from stylit_ref.files.motion_flo import write_flo

GUIDES = [
    {"source": "source_0.png", "view": "target_0.{view}.png"},
    {"source": "source_1.png", "view": "target_1.{view}.png", "weight": 2},
]
MANIFEST = {
    "style": "style.png",
    "guides": GUIDES,
    "grid": [["0001", "0002", "0003"]],
    "motion": "flow.{view}_to_{other}.flo",
}


@pytest.fixture
def grid(shot):
    """The shot as a row of views with a file of motion for each pair: (folder, manifest)."""
    folder, frames = shot[0], shot[3]
    for to, other in ((1, 2), (2, 1), (2, 3), (3, 2)):
        flow = np.tile(np.float32([other - to, 0]), (*frames[0][0].shape[:2], 1))
        write_flo(folder / f"flow.{to:04d}_to_{other:04d}.flo", flow)
    return folder, MANIFEST


def views(folder, manifest, *more):
    """Call ``views``."""
    (folder / "grid.json").write_text(json.dumps(manifest), encoding="utf-8")
    command = [
        "views",
        "--manifest",
        f"{folder}/grid.json",
        "--output",
        f"{folder}/out.{{view}}.png",
    ]
    return main([*command, *QUICK, *map(str, more)])


def test_it_writes_what_stylize_views_yields(shot, grid):
    _, style, sources, frames = shot
    folder, manifest = grid
    assert views(folder, manifest) == 0
    size = frames[0][0].shape[:2]
    inside = np.arange(size[1]) + np.array([[1], [-1]])
    shown = {
        step: np.tile((place >= 0) & (place < size[1]), (size[0], 1))
        for step, place in zip((1, -1), inside, strict=True)
    }
    edges = {
        (to, to + step): Motion(np.tile(np.float32([step, 0]), (*size, 1)), shown[step])
        for to, step in ((0, 1), (1, -1), (1, 1), (2, -1))
    }
    params = Params(levels=2, votes=1, patchmatch_iterations=1, guide_weights=(1, 2))
    for result in stylize_views(style, sources, frames, params, Coherence(), edges=edges):
        image = read_image(folder / f"out.000{result.frame + 1}.png")
        np.testing.assert_array_equal(image, result.image)


def test_pairs_are_as_good_as_a_grid(grid):
    folder, manifest = grid
    assert views(folder, manifest) == 0
    expected = [read_image(folder / f"out.{name}.png") for name in manifest["grid"][0]]
    row = manifest["grid"][0]
    pairs = [[row[0], row[1]], [row[1], row[0]], [row[1], row[2]], [row[2], row[1]]]
    others = {key: value for key, value in manifest.items() if key != "grid"}
    assert views(folder, others | {"pairs": pairs}) == 0
    for name, image in zip(row, expected, strict=True):
        np.testing.assert_array_equal(read_image(folder / f"out.{name}.png"), image)


def test_views_without_motion_are_stylized_each_by_itself(grid, capsys):
    folder, manifest = grid
    alone = {key: value for key, value in manifest.items() if key != "motion"}
    assert views(folder, alone) == 0
    assert "each view is stylized by itself" in capsys.readouterr().err
    message = refused(capsys, views(folder, alone, "--coherence", 1))
    assert "--coherence is of use with motion in the manifest alone" in message


def test_another_painting(grid):
    folder, manifest = grid
    write_image(folder / "black.png", np.zeros((40, 46, 3), np.uint8))
    assert views(folder, manifest, "--style", folder / "black.png") == 0
    assert not read_image(folder / "out.0001.png").any()


def test_missing_files_are_all_named_at_once(grid, capsys):
    folder, manifest = grid
    missing = [folder / "style.png", folder / "target_1.0002.png", folder / "flow.0001_to_0002.flo"]
    for file in missing:
        file.unlink()
    message = refused(capsys, views(folder, manifest))
    assert message == f"stylit-ref: no such files: {', '.join(map(str, missing))}"
    assert not list(folder.glob("out*"))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"style": None}, "style of it is None; it must be a text"),
        ({"grids": []}, "it has 'grids'; known are style, guides, grid"),
        ({"guides": []}, "guides is empty"),
        ({"guides": [{"source": "a.png"}]}, "guide 1 lacks 'view'"),
        ({"guides": [{"source": "a.png", "view": "b.png"}]}, "'b.png' lacks {view}"),
        (
            {"guides": [GUIDES[0] | {"weight": True}]},
            "weight of guide 1 is True; it must be a",
        ),
        ({"grid": [["a"], ["b", "c"]]}, "the rows of grid must be equally long"),
        ({"grid": [["a", "a"]]}, "no view may be there twice"),
        ({"grid": ["a"]}, "grid must be a list of rows"),
        ({"pairs": [["a", "b"]]}, "either grid, which has rows of views, or pairs"),
        ({"motion": "flow.{view}.flo"}, "'flow.{view}.flo' lacks {other}"),
        ({"guide": []}, "it has 'guide'; known are style, guides, grid,"),
        ({"guide": []}, "; did you mean guides?"),
        ({"guides": [{"sorce": "a.png"}]}, "guide 1 has 'sorce'; known are source, view, weight;"),
        ({"motion_convention": "blend"}, "'blend'; write auto or one of"),
        ({"cameras": {"4": {}}}, "cameras has '4', which is none of the views"),
        (
            {"mesh": "a.obj", "cameras": {"0001": {"fov": 30}}},
            "the camera of 0001 lacks 'origin', and has 'fov'",
        ),
        ({"positions": "p.exr"}, "'p.exr' lacks {view}"),
        ({"mesh": "a.obj", "positions": "{view}.exr"}, "mesh and positions tell the same; leave"),
    ],
)
def test_a_manifest_that_cannot_be_used(grid, capsys, change, said):
    folder, manifest = grid
    message = refused(capsys, views(folder, manifest | change))
    assert message.startswith(f"stylit-ref: {folder}/grid.json: ")
    assert said in message
    assert not list(folder.glob("out*"))


def test_what_is_no_manifest(grid, capsys):
    folder = grid[0]
    assert "it is not an object with the keys" in refused(capsys, views(folder, []))
    command = ["views", "--output", "{view}.png", "--manifest"]
    assert "no such file" in refused(capsys, main([*command, f"{folder}/none.json"]))
    (folder / "broken.json").write_text("{", encoding="utf-8")
    assert "is no JSON" in refused(capsys, main([*command, f"{folder}/broken.json"]))


TRIANGLE = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"


def test_a_run_holds_the_mesh_that_the_manifest_names(grid):
    folder, manifest = grid
    (folder / "scene.obj").write_text(TRIANGLE)
    assert views(folder, manifest | {"mesh": "scene.obj"}, "--run", folder / "run") == 0
    run = Run(folder / "run")
    assert run.mesh().vertices.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    assert run.mesh().faces.tolist() == [[0, 1, 2]]


def test_a_run_holds_the_positions_that_the_manifest_names(grid):
    folder, manifest = grid
    points = np.random.default_rng(1).random((38, 44, 3), np.float32)
    points[:, :5] = 0
    ids = np.zeros((38, 44), np.uint8)
    ids[:, 10:], ids[:, 20:] = 3, 7
    for name in manifest["grid"][0]:
        write_image(folder / f"at.{name}.exr", points)
        write_image(folder / f"id.{name}.png", ids)
    told = manifest | {"positions": "at.{view}.exr"}
    assert views(folder, told, "--run", folder / "run") == 0
    found = Run(folder / "run").positions(1)
    np.testing.assert_array_equal(found.points, points)
    np.testing.assert_array_equal(found.labels, np.where(np.arange(44) < 5, -1, 0) + 0 * ids)
    assert views(folder, told | {"ids": "id.{view}.png"}, "--run", folder / "run") == 0
    labels = Run(folder / "run").positions(0).labels[0]
    assert labels[9] == -1
    assert labels[10] != labels[20]


def test_positions_that_do_not_fit_are_refused_before_anything_is_written(grid, capsys):
    folder, manifest = grid
    cameras = {
        name: {"origin": [0, 0, 9 + k], "target": [0, 0, 0], "field_of_view": 30}
        for k, name in enumerate(manifest["grid"][0])
    }
    for name in manifest["grid"][0]:
        write_image(folder / f"at.{name}.exr", np.ones((38, 44, 3), np.float32))
    told = manifest | {"positions": "at.{view}.exr", "cameras": cameras}
    del told["motion"]
    message = refused(capsys, views(folder, told, "--run", folder / "run"))
    first = manifest["grid"][0][0]
    assert f"{folder}/at.{first}.exr: the camera of {first} sees the points" in message
    write_image(folder / f"at.{first}.exr", np.ones((38, 40, 3), np.float32))
    message = refused(capsys, views(folder, told, "--run", folder / "run"))
    assert f"the positions of {first} are 40x38, and its views are 44x38; render both" in message
    assert not (folder / "run").exists()


def test_a_mesh_that_is_none_is_refused_before_anything_is_written(grid, capsys):
    folder, manifest = grid
    (folder / "scene.obj").write_text("v 0 0 0\n")
    told = manifest | {"mesh": "scene.obj"}
    message = refused(capsys, views(folder, told, "--run", folder / "run"))
    assert f"{folder}/scene.obj: holds no faces; export the scene with its faces" in message
    assert not (folder / "run").exists()


def test_outputs_name_the_view(grid, capsys):
    folder, manifest = grid
    message = refused(capsys, views(folder, manifest, "--output", "out.png"))
    assert "--output out.png: names one file; write {view}" in message
