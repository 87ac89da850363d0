"""Light passes against the renderer's own integrators; motion fields against positions."""

import numpy as np
import pytest
from scipy.ndimage import map_coordinates

from data_gen.renderer import MissingRendererError, start

try:
    start()
except MissingRendererError as error:
    pytest.skip(str(error), allow_module_level=True)

import mitsuba as mi

from data_gen.camera import GRID, HOUSE_SOURCE, STAGE, STAGE_VIEW
from data_gen.features import HIGHLIGHT, features, trace
from data_gen.light_paths import LONGEST_PATH, PASSES
from data_gen.load import load
from data_gen.manifest import Manifest
from data_gen.models import sphere
from data_gen.models.mesh import polygons, rotation
from data_gen.models.teapot import teapot
from data_gen.motion import motion_field
from data_gen.multilayer_exr import read_layers
from data_gen.pieces import View
from data_gen.produce import produce
from data_gen.rendering import Rendering
from data_gen.scenes import turning
from data_gen.stage import Material, house_scene, on_stage
from data_gen.visibility import sees
from data_gen.wireframe import visible_wires, wireframe

pytestmark = pytest.mark.slow

HEIGHT, WIDTH = 46, 60
SAMPLES = 1024


@pytest.fixture(scope="module")
def stage():
    return on_stage(teapot(steps=12))


def rendered(scene, integrator, camera=STAGE_VIEW, seed=0):
    loaded = load(scene, camera, HEIGHT, WIDTH, SAMPLES, integrator)
    return np.array(mi.render(loaded, seed=seed)).astype(float)


def passes(scene, camera=STAGE_VIEW):
    image = rendered(scene, {"type": "light_paths"}, camera)[..., 3:]  # after the film's own
    return {name: image[..., 3 * k : 3 * k + 3] for k, name in enumerate(PASSES)}


def assert_same_light(ours, theirs):
    """Equal within noise: nowhere biased, and pixels differ as two renders do."""
    assert ours.sum() == pytest.approx(theirs.sum(), rel=0.005)
    for region in np.split(np.arange(HEIGHT), [15, 30]):
        assert ours[region].sum() == pytest.approx(theirs[region].sum(), rel=0.02)
    assert np.abs(ours - theirs).mean() < 0.03 * theirs.mean()


@pytest.mark.parametrize("camera", [STAGE_VIEW, HOUSE_SOURCE], ids=["stage", "house"])
def test_full_is_what_the_path_tracer_renders(stage, camera):
    scene = stage if camera == STAGE_VIEW else house_scene()
    path = {"type": "path", "max_depth": LONGEST_PATH + 1, "rr_depth": 100}
    assert_same_light(passes(scene, camera)["FULL"], rendered(scene, path, camera, seed=1))


def test_direct_passes_add_up_to_direct_light(stage):
    ours = passes(stage)
    assert_same_light(ours["LDE"] + ours["LSE"], rendered(stage, {"type": "direct"}, seed=1))


def test_diffuse_passes_add_up_to_two_bounces_where_nothing_shines(stage):
    matt = {name: Material(m.reflectance) for name, m in stage.materials.items()}
    scene = stage._replace(materials=matt)
    ours = passes(scene)
    assert np.abs(ours["LSE"]).max() < 1e-9
    two = {"type": "path", "max_depth": 3, "rr_depth": 100}
    assert_same_light(ours["LDE"] + ours["LDDE"], rendered(scene, two, seed=1))


def test_highlights_have_the_colour_of_the_light(stage):
    ours = passes(stage)["LSE"]
    assert ours.max() > 0.3
    assert np.ptp(ours, axis=-1).max() < 1e-4 * ours.max()


def test_lobes_are_split_by_what_they_reflect(stage):
    """Colours of a glossy object: what two red surfaces send on is red squared."""
    ours = passes(stage)
    on_object = ours["LDE"][..., 0] > 20 * ours["LDE"][..., 1]
    assert on_object.mean() > 0.05
    red, green = stage.materials["object"].reflectance[:2]
    ratio = ours["LDE"][on_object].sum(axis=0)
    # nonlinearity of the coat aside, direct light has the ratio of the reflectances
    assert ratio[1] / ratio[0] == pytest.approx(green / red, rel=0.1)
    indirect = ours["LDDE"][on_object].sum(axis=0)
    assert indirect[1] / indirect[0] < 1.6 * green / red + 0.02


def test_no_pass_exceeds_the_whole(stage):
    ours = passes(stage)
    assert (ours["LDE"] + ours["LSE"] + ours["LDDE"] <= ours["FULL"] + 1e-4).all()


def test_features_of_a_sphere():
    """Where the sphere is, what it looks like is known in closed form."""
    scene = on_stage(sphere())
    loaded = load(scene, STAGE_VIEW, HEIGHT, WIDTH, 1, {"type": "path"})
    surface = trace(loaded, scene, STAGE_VIEW, HEIGHT, WIDTH)
    layers = features(loaded, scene, STAGE_VIEW, surface, np.zeros((HEIGHT, WIDTH, 3)))
    eye, middle = np.array(STAGE_VIEW.origin), np.array([0, 1, 0])
    along = ((middle - eye) * surface.directions).sum(axis=-1)
    reach = along**2 - ((middle - eye) ** 2).sum() + 1
    hit = reach > 0.02
    assert (layers["IDMASK"][hit] == (1, 0, 0)).all()
    assert (layers["IDMASK"][reach < -0.02][:, 0] == 0).all()
    position = eye + (along - np.sqrt(np.maximum(reach, 0)))[..., None] * surface.directions
    assert np.abs(layers["POSITION"] - position)[hit].max() < 0.01
    assert np.abs(layers["NORMAL"] - (position - middle))[hit].max() < 0.02
    cosine = -(surface.directions * (position - middle)).sum(axis=-1)
    assert np.abs(layers["FRESNEL"][..., 0] - (0.04 + 0.96 * (1 - cosine) ** 5))[hit].max() < 0.03
    forward = STAGE_VIEW.axes()[2]
    assert layers["DEPTH"][..., 0][hit] == pytest.approx(
        ((position - eye) @ forward)[hit], abs=0.01
    )
    assert (layers["LIGHTMASK"].sum(axis=-1) == 1).all()
    towards = np.array(scene.light.middle) - position
    dark = hit & ((towards * (position - middle)).sum(axis=-1) < -0.8)
    assert dark.any()
    assert (layers["LIGHTMASK"][dark] == (0, 0, 1)).all()


@pytest.mark.parametrize("other", [(1, 2), (0, 1)])
def test_motion_leads_to_the_same_point_within_a_pixel(other):
    """What is visible in both views: positions there, looked up by the motion field."""
    height, width = 228, 300
    scene = house_scene()
    loaded = load(scene, HOUSE_SOURCE, height, width, 1, {"type": "path"})
    here = trace(loaded, scene, GRID[1, 1], height, width)
    there = trace(loaded, scene, GRID[other], height, width)
    motion, visible = motion_field(loaded, here, GRID[other])
    y, x = np.mgrid[:height, :width]
    place = [y + motion[..., 1], x + motion[..., 0]]
    found = [map_coordinates(there.position[..., c], place, order=1) for c in range(3)]
    found = GRID[other].project(np.stack(found, axis=-1), height, width)
    error = np.linalg.norm(found - np.stack(place, axis=-1), axis=-1)
    seen = visible[..., 0] > 0
    assert 0.5 < seen.mean() < 0.95
    # Interpolated positions mean something only within one surface.
    part = there.part.astype(float)
    same = seen & (map_coordinates(part, place, order=1, cval=-9) == here.part)
    normal = [map_coordinates(there.normal[..., c], place, order=1) for c in range(3)]
    same &= np.linalg.norm(np.stack(normal, axis=-1) - here.normal, axis=-1) < 1e-3
    assert same.sum() > 0.8 * seen.sum()
    assert np.quantile(error[same], 0.99) < 0.1
    assert np.abs(motion[same]).max() > 5


def test_a_view_sees_what_it_sees():
    scene = house_scene()
    loaded = load(scene, HOUSE_SOURCE, HEIGHT, WIDTH, 1, {"type": "path"})
    here = trace(loaded, scene, GRID[1, 1], HEIGHT, WIDTH)
    _, visible = motion_field(loaded, here, GRID[1, 1])
    assert (visible[..., 0] == (here.part >= 0)).mean() > 0.995


def test_what_stands_between_hides():
    """Ground behind the sphere faces the eye, inside the picture, and is not seen."""
    scene = on_stage(sphere())
    loaded = load(scene, STAGE_VIEW, HEIGHT, WIDTH, 1, {"type": "path"})
    ground = np.array([(0.0, 0.0, -1.6), (0.0, 0.0, 2.0), (2.5, 0.0, -1.6)])
    up = np.tile((0.0, 1.0, 0.0), (3, 1))
    seen = sees(loaded, ground, up, np.array(STAGE_VIEW.origin))
    assert seen.tolist() == [False, True, True]
    assert not sees(loaded, ground, -up, np.array(STAGE_VIEW.origin)).any()


def test_the_renderer_has_the_same_camera(stage):
    """Where the renderer sees the red object is where rays of our camera meet it."""
    image = passes(stage)["LDDE"]
    loaded = load(stage, STAGE_VIEW, HEIGHT, WIDTH, 1, {"type": "path"})
    surface = trace(loaded, stage, STAGE_VIEW, HEIGHT, WIDTH)
    red = image[..., 0] > 3 * image[..., 1]
    assert (red == (surface.part == 0)).mean() > 0.97


def test_highlights_are_masked_where_they_are_bright():
    scene = on_stage(sphere())
    loaded = load(scene, STAGE_VIEW, HEIGHT, WIDTH, 1, {"type": "path"})
    surface = trace(loaded, scene, STAGE_VIEW, HEIGHT, WIDTH)
    highlights = np.zeros((HEIGHT, WIDTH, 3), np.float32)
    highlights[20:23, 28:32] = HIGHLIGHT + 0.1
    highlights[24:26, 28:32] = HIGHLIGHT - 0.1
    mask = features(loaded, scene, STAGE_VIEW, surface, highlights)["LIGHTMASK"]
    assert mask[..., 0].sum() == 12
    assert mask[20:23, 28:32, 0].all()


def test_wires_are_drawn_where_they_are_seen():
    """Three squares facing the eye: one behind another is not drawn, the third is."""
    corners = np.array([(-0.8, 0, 0), (0.8, 0, 0), (0.8, 1.6, 0), (-0.8, 1.6, 0)])
    places = np.array([(-1, 0.3, 1.0), (-1, 0.6, 0.0), (1.2, 0.6, 0.0)])
    front, behind, aside = corners + places[0], *(0.5 * corners + place for place in places[1:])
    scene = on_stage(polygons([front, behind, aside]))
    loaded = load(scene, STAGE_VIEW, 228, 300, 1, {"type": "path"})
    wires = visible_wires(loaded, scene, STAGE_VIEW, 228, 300)
    drawn = wireframe(wires, 228, 300)[..., 0]

    def on(square, shift=0.0):
        middles = (square + np.roll(square, -1, axis=0)) / 2
        at = np.round(STAGE_VIEW.project(middles, 228, 300) + shift).astype(int)
        return drawn[at[:, 0], at[:, 1]]

    assert (on(front) > 0.3).all()
    assert (on(aside) > 0.3).all()
    assert (on(behind) < 0.05).all()
    assert (on(front, 4.0) < 0.05).all()


def test_runs_of_wires_end_where_something_hides_them_and_are_listed_once():
    """Two squares that share an edge, which a third one hides in its middle."""
    left = np.array([(-1.0, 0.2, 0), (0, 0.2, 0), (0, 1.8, 0), (-1.0, 1.8, 0)])
    cover = np.array([(-0.3, 0.8, 0.5), (0.3, 0.8, 0.5), (0.3, 1.2, 0.5), (-0.3, 1.2, 0.5)])
    scene = on_stage(polygons([left, left + np.array([1.0, 0, 0]), cover]))
    loaded = load(scene, STAGE_VIEW, 228, 300, 1, {"type": "path"})
    runs = visible_wires(loaded, scene, STAGE_VIEW, 228, 300).runs()
    ends = STAGE_VIEW.project(np.array([(0, 0.2, 0), (0, 1.8, 0)]), 228, 300)[:, ::-1]
    on_edge = (np.abs(runs[..., 0] - ends[0, 0]) < 1).all(axis=1)
    upright = runs[on_edge & (np.abs(np.diff(runs[..., 1], axis=1)[:, 0]) > 5)]
    assert len(upright) == 2
    rows = np.sort(upright[..., 1].ravel())
    assert rows[[0, 3]] == pytest.approx(np.sort(ends[:, 1]), abs=1.5)
    hidden = STAGE_VIEW.project(cover, 228, 300)[[0, 2], 0]
    assert rows[[1, 2]] == pytest.approx(np.sort(hidden), abs=2.5)
    assert len(runs) == 4 + 3 + 3 + 2  # of the cover, of each square, of the shared edge


def test_a_second_set_has_the_same_bytes_and_resumes(tmp_path):
    for name in "ab":
        made = produce(tmp_path / name, (WIDTH, HEIGHT), ["teapot"], samples=4)
        assert made == ["source", "teapot"]
    manifests = [Manifest.read(tmp_path / name) for name in "ab"]
    assert manifests[0].pieces == manifests[1].pieces
    assert len(manifests[0].pieces["teapot"]) == 13
    assert manifests[0].styles == ["crayon", "oil", "pen", "watercolour"]

    (tmp_path / "a" / "teapot" / "LDE.png").unlink()
    assert produce(tmp_path / "a", (WIDTH, HEIGHT), ["teapot"], samples=4) == ["teapot"]
    assert produce(tmp_path / "a", (WIDTH, HEIGHT), ["teapot"], samples=4) == []
    assert Manifest.read(tmp_path / "a").pieces == manifests[1].pieces


def test_an_interrupted_piece_leaves_the_finished_ones(tmp_path, monkeypatch):
    make = View.make

    def interrupted(self, *arguments):
        if self.name == "teapot":
            raise KeyboardInterrupt
        return make(self, *arguments)

    monkeypatch.setattr(View, "make", interrupted)
    with pytest.raises(KeyboardInterrupt):
        produce(tmp_path / "a", (WIDTH, HEIGHT), ["teapot"], samples=4)
    monkeypatch.undo()
    assert Manifest.read(tmp_path / "a").complete("source")
    assert produce(tmp_path / "a", (WIDTH, HEIGHT), ["teapot"], samples=4) == ["teapot"]
    assert sorted(file.name for file in (tmp_path / "a").iterdir()) == [
        "manifest.json", "source", "teapot",
    ]  # fmt: skip


def turned_teapot(folder, degrees, cameras=(STAGE_VIEW, STAGE_VIEW)):
    """What two frames see of a teapot that turns, and the motion fields between them."""
    size = WIDTH * 3, HEIGHT * 3
    *_, motion = turning("turning", lambda: teapot(steps=12), cameras, degrees)
    motion.make(folder, Rendering(size, 1, 0), exr=False)
    surfaces = []
    for scene, camera in zip((build() for build in motion.scenes), cameras, strict=True):
        loaded = load(scene, camera, *size[::-1], 1, {"type": "path"})
        surfaces.append(trace(loaded, scene, camera, *size[::-1]))
    return *surfaces, read_layers(folder / "00_to_01.exr"), read_layers(folder / "01_to_00.exr")


def distance_after(motion, here, there, degrees, part):
    """How far the points of a part are from those that its motion leads to, where both are seen."""
    y, x = np.mgrid[: HEIGHT * 3, : WIDTH * 3]
    place = [y + motion["MOTION"][..., 1], x + motion["MOTION"][..., 0]]
    same = motion["VISIBLE"][..., 0] > 0
    same &= map_coordinates(there.part.astype(float), place, order=1, cval=-9) == part
    found = [map_coordinates(there.position[..., c], place, order=1) for c in range(3)]
    back = np.stack(found, axis=-1) @ rotation(-degrees).T
    assert same[here.part == part].mean() > 0.8
    return np.linalg.norm(back - here.position, axis=-1)[same & (here.part == part)]


def test_motion_of_a_turn_leads_to_the_same_point_of_the_object(tmp_path):
    here, there, forward, _ = turned_teapot(tmp_path, 5.0)
    on_object = here.part == 0
    assert np.quantile(distance_after(forward, here, there, 5.0, part=0), 0.95) < 0.01
    assert np.abs(forward["MOTION"][on_object]).max() > 3
    assert np.abs(forward["MOTION"][~on_object]).max() < 1e-3


def test_motion_leads_to_the_same_point_if_the_camera_moves_as_well(tmp_path):
    cameras = STAGE.at(0, 10), STAGE.at(-6, 12)
    first, second, forward, backward = turned_teapot(tmp_path, 5.0, cameras)
    for motion, here, there, degrees in (
        (forward, first, second, 5.0),
        (backward, second, first, -5.0),
    ):
        assert np.quantile(distance_after(motion, here, there, degrees, part=0), 0.95) < 0.01
        assert np.quantile(distance_after(motion, here, there, 0.0, part=1), 0.95) < 0.01
        assert np.median(np.abs(motion["MOTION"][here.part == 1][:, 0])) > 3


def test_ground_is_hidden_by_where_the_object_is_in_the_other_frame(tmp_path):
    first, second, forward, backward = turned_teapot(tmp_path, 20.0)
    for layers, here, there in ((forward, first, second), (backward, second, first)):
        ground = here.part == 1
        assert ((layers["VISIBLE"][ground][:, 0] > 0) == (there.part[ground] == 1)).mean() > 0.99
        assert (there.part[ground] == 0).any()
