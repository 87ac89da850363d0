"""``stylit-ref viewer``: what it writes, what it says, what it refuses."""

import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from cli.calls import refused
from small_run import SIZE, camera_at, facts_of, write_run

from stylit_ref import write_image
from stylit_ref.cli import main, viewer
from stylit_ref.views.run_folder import Run


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    folder = tmp_path_factory.mktemp("my secret place") / "run"
    write_run(folder)
    return folder


def text_of(page):
    """A page, each byte as a character."""
    return page.read_bytes().decode("latin-1")


def table_of(page):
    """A page's table of contents."""
    text = text_of(page)
    return json.loads(re.search(r'id="stylit-data">(.*?)</script>', text, re.DOTALL)[1])


def test_one_file_holds_everything(run, tmp_path, capsys):
    page = tmp_path / "page.html"
    assert main(["viewer", str(run), "--output", str(page), "--title", "A <box> – 箱"]) == 0
    said = capsys.readouterr().err
    assert re.search(rf"wrote {re.escape(str(page))} with 6 views, 0\.\d MB$", said.strip())
    table = table_of(page)
    assert (table["title"], table["width"], table["height"]) == ("A <box> – 箱", SIZE[1], SIZE[0])
    assert table["columns"]["positions"] == pytest.approx([-10, 0, 12])
    assert table["columns"]["isRing"] is False
    assert len(table["views"]) == 6
    assert all(view["nnf"]["coding"] == "deflate" for view in table["views"])
    text = text_of(page)
    assert "<title>A &lt;box&gt; &#8211; &#31665;</title>" in text
    assert not re.search(r'(src|href)="', text)


def test_nothing_of_the_disk_is_in_a_page(run, tmp_path):
    page = tmp_path / "page.html"
    main(["viewer", str(run), "--output", str(page), "--quiet"])
    text = text_of(page)
    for name in ("secret", str(tmp_path), run.name + "/", "digests", *Run(run).facts["digests"]):
        assert name not in text


def test_a_folder_has_a_script_for_each_piece(run, tmp_path):
    assert main(["viewer", str(run), "--folder", str(tmp_path / "page"), "--quiet"]) == 0
    files = {file.name for file in (tmp_path / "page").rglob("*") if file.is_file()}
    views = {f"view-{row}-{column}.js" for row in range(2) for column in range(3)}
    assert files == {"index.html", "viewer.js", "style.js", "mesh.js", *views}


def test_pieces_of_an_earlier_page_are_taken_away(run, tmp_path):
    write_image(tmp_path / "large.png", Run(run).style().repeat(2, axis=0).repeat(2, axis=1))
    command = ["viewer", str(run), "--folder", str(tmp_path / "page"), "--quiet"]
    assert main([*command, "--still", str(tmp_path / "large.png")]) == 0
    own = tmp_path / "page/data/own.js"
    own.write_text("// of somebody else")
    before = {file.name for file in (tmp_path / "page/data").iterdir()}
    assert main(command) == 0
    after = {file.name for file in (tmp_path / "page/data").iterdir()}
    assert before - after == {"still.js"}
    assert own.exists()


def test_stills_need_nnfs(manifest, tmp_path, capsys):
    command = ["viewer", manifest(pictures="{view}.png"), "--still", str(tmp_path / "style.png")]
    said = refused(capsys, main([*command, "--output", str(tmp_path / "page.html")]))
    assert "--still is for views that tell where their pixels come from" in said


def test_cameras_without_a_mesh_are_told(manifest, tmp_path, capsys):
    command = ["viewer", manifest(nnfs="{view}.npy", style="style.png")]
    assert main([*command, "--output", str(tmp_path / "page.html")]) == 0
    assert "has cameras and no mesh, so the page can only blend views" in capsys.readouterr().err


def test_a_style_for_stills_tells_its_weight(run, tmp_path, capsys):
    style = Run(run).style().repeat(3, axis=0).repeat(3, axis=1)
    write_image(tmp_path / "large.png", style)
    options = ["--still", str(tmp_path / "large.png"), "--output", str(tmp_path / "page.html")]
    assert main(["viewer", str(run), *options]) == 0
    assert "the style for stills takes 0.0 MB of it" in capsys.readouterr().err
    assert table_of(tmp_path / "page.html")["still"]["scale"] == 3


def test_a_large_file_is_doubted(run, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(viewer, "LARGEST_PAGE", 1000)
    assert main(["viewer", str(run), "--output", str(tmp_path / "page.html")]) == 0
    assert "write a folder by --folder" in capsys.readouterr().err


def test_views_without_a_mesh_are_blended(tmp_path, capsys):
    write_run(tmp_path / "run", holds=None)
    assert main(["viewer", str(tmp_path / "run"), "--output", str(tmp_path / "page.html")]) == 0
    assert "can only blend views" in capsys.readouterr().err
    table = table_of(tmp_path / "page.html")
    assert (table["mesh"], table["views"][0]["camera"]) == (None, None)
    assert table["columns"]["positions"] == pytest.approx([-10, 0, 12])


def test_positions_go_into_a_page_where_there_is_no_mesh(tmp_path):
    write_run(tmp_path / "run", holds="positions")
    page = tmp_path / "page.html"
    assert main(["viewer", str(tmp_path / "run"), "--output", str(page), "--quiet"]) == 0
    table = table_of(page)
    assert table["mesh"] is None
    assert all(view["points"] and view["camera"] for view in table["views"])


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--output", "page.png"], "page.png: a page ends in .html"),
        (["--output", "page.html", "--fade", "2"], "--fade is 2; it must be between 0 and 1"),
        (["--output", "page.html", "--still", "odd.png"], "--still is 7x5, but the style"),
        (["--output", "nowhere/x/../page.html", "--still", "no.png"], "no.png: no such file"),
    ],
)
def test_what_cannot_be_is_refused(run, tmp_path, capsys, monkeypatch, options, said):
    monkeypatch.chdir(tmp_path)
    write_image("odd.png", np.zeros((5, 7, 3), np.uint8))
    assert said in refused(capsys, main(["viewer", str(run), *options]))
    assert {file.name for file in tmp_path.iterdir()} == {"odd.png"}


def test_runs_that_cannot_be_shown_are_refused(tmp_path, capsys):
    page = ["--output", str(tmp_path / "page.html")]
    assert "is no RUN" in refused(capsys, main(["viewer", str(tmp_path), *page]))
    write_run(tmp_path / "one", cameras=[camera_at(0, 10)], grid=(1, 1))
    assert "nothing lies between" in refused(capsys, main(["viewer", str(tmp_path / "one"), *page]))
    nan = [facts_of(camera_at(azimuth, 10)) for azimuth in (0, 5)]
    nan[1]["origin"] = [0.0, float("nan"), 1.0]
    cameras = [camera_at(0, 10), camera_at(5, 10)]
    write_run(tmp_path / "nan", cameras=cameras, grid=(1, 2), facts=nan)
    assert "finite numbers" in refused(capsys, main(["viewer", str(tmp_path / "nan"), *page]))
    write_run(tmp_path / "other", motion_scale=3.0)
    assert "do not match its motion" in refused(
        capsys, main(["viewer", str(tmp_path / "other"), *page])
    )
    assert not (tmp_path / "page.html").exists()


@pytest.fixture
def manifest(run, tmp_path):
    """Writes a manifest of the RUN's files, as another program would."""
    names = [[f"{row}{column}" for column in range(3)] for row in range(2)]
    frames = [name for row in names for name in row]
    facts = Run(run).facts
    for name, frame in zip(frames, facts["frames"], strict=True):
        for kind in ("picture", "nnf"):
            shutil.copy(run / frame[kind], tmp_path / (name + Path(frame[kind]).suffix))
    shutil.copy(run / facts["style"], tmp_path / "style.png")
    cameras = {name: frame["camera"] for name, frame in zip(frames, facts["frames"], strict=True)}

    def written(**content):
        file = tmp_path / "viewer.json"
        file.write_text(json.dumps({"grid": names, "cameras": cameras} | content))
        return str(file)

    return written


def test_nnfs_of_any_program_make_the_same_views(run, manifest, tmp_path):
    theirs, ours = tmp_path / "theirs.html", tmp_path / "ours.html"
    file = manifest(nnfs="{view}.npy", style="style.png", patch_width=5)
    assert main(["viewer", file, "--output", str(theirs), "--quiet"]) == 0
    assert main(["viewer", str(run), "--output", str(ours), "--quiet"]) == 0
    assert table_of(theirs)["views"] == table_of(ours)["views"]


def test_a_scene_5000_km_away_is_centred_in_its_page(run, manifest, tmp_path):
    far, mesh = np.array([5e6, 0.0, -1e6]), Run(run).mesh()
    lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in (mesh.vertices.astype(float) + far).tolist()]
    lines += [f"f {a} {b} {c}" for a, b, c in (mesh.faces + 1).tolist()]
    (tmp_path / "far.obj").write_text("\n".join(lines))
    near = json.loads(Path(manifest()).read_text())["cameras"]
    cameras = {
        name: facts | {key: (far + facts[key]).tolist() for key in ("origin", "target")}
        for name, facts in near.items()
    }
    page = tmp_path / "page.html"
    file = manifest(pictures="{view}.png", cameras=cameras, mesh="far.obj")
    assert main(["viewer", file, "--output", str(page), "--quiet"]) == 0
    middle = (mesh.vertices.min(axis=0) + mesh.vertices.max(axis=0)) / 2
    for view, facts in zip(table_of(page)["views"], near.values(), strict=True):
        assert view["camera"]["origin"] == pytest.approx(facts["origin"] - middle, abs=1e-6)


def test_pictures_alone_make_a_page(manifest, tmp_path):
    page = tmp_path / "page.html"
    assert main(["viewer", manifest(pictures="{view}.png"), "--output", str(page), "--quiet"]) == 0
    table = table_of(page)
    assert table["style"] is None
    assert all(view["picture"] and not view["nnf"] for view in table["views"])


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ({}, "needs nnfs or pictures"),
        ({"nnfs": "{view}.npy"}, "needs style"),
        ({"pictures": "{view}.png", "speed": 1}, "has 'speed'; known are grid, nnfs"),
        (
            {"picture": "{view}.png"},
            "has 'picture'; known are grid, nnfs, style, patch_width, "
            "pictures, cameras, mesh; did you mean pictures?",
        ),
        ({"guides": [], "motion": "m"}, "--run RUN, and name RUN in place of the manifest"),
        ({"pictures": "{view}.png", "grid": [["00"]]}, "at least two in all"),
        ({"pictures": "{view}.png", "cameras": {}}, "there is no camera of 00; the views between"),
        ({"pictures": "{view}.png", "cameras": {"00": 5}}, "the camera of 00 is 5; it must be an"),
        ({"pictures": "{view}.png", "cameras": {"00": None}}, "there is no camera of 00"),
        ({"pictures": "{view}.png", "mesh": 7}, "mesh is 7; it must be the name of a file"),
        ({"nnfs": "{view}.npy", "style": "00.png", "patch_width": 4}, "patch_width is 4"),
        ({"nnfs": "{view}.npy", "style": "small.png"}, "patches of width 5 lie within the style"),
        ({"pictures": "{view}.png", "grid": [["00", "small"]]}, "all views must have one size"),
    ],
)
def test_manifests_that_cannot_be_are_refused(manifest, tmp_path, capsys, content, said):
    write_image(tmp_path / "small.png", np.zeros((9, 9, 3), np.uint8))
    page = tmp_path / "page.html"
    if "grid" in content:
        content = content | {"cameras": {n: facts_of(camera_at(k, 9)) for k, n in
                                         enumerate(("00", "small"))}}  # fmt: skip
    code = main(["viewer", manifest(**content), "--output", str(page)])
    assert said in refused(capsys, code)
    assert not page.exists()
