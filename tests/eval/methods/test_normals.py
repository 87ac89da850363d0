"""Lit Sphere and StyleBlit where a sphere stands for itself, and against slow twins."""

from dataclasses import replace

import numpy as np
import pytest

from eval.methods.lit_sphere import LitSphere
from eval.methods.normal_table import normal_table, objects
from eval.methods.styleblit import StyleBlit, assign, make_jitter
from eval.scenes import load_scene
from stylit_ref import InputError


@pytest.fixture(scope="module")
def scene():
    return load_scene("golem/oil", step=3, buffers=("NORMAL", "IDMASK"))


@pytest.fixture(scope="module")
def sphere(scene):
    """The painted sphere as its own target."""
    return replace(scene, buffers={name: (s, s) for name, (s, _) in scene.buffers.items()})


def test_the_table_names_the_nearest_normal(scene):
    source, target = objects(scene)
    table = normal_table(source)
    own = source.normals[source.mask].astype(int)
    found = source.normals.reshape(-1, 3)
    for normal in target.normals[target.mask][::97]:
        place = table[normal[2] >> 7, normal[0], normal[1]]
        assert source.mask.ravel()[place]
        error = np.linalg.norm(found[place].astype(int) - normal)
        assert error <= np.linalg.norm(own - normal, axis=1).min() + 2  # z is rounded anew


def test_lit_sphere_colours_the_object_alone(scene):
    image = LitSphere().run(scene, 0).image
    source, target = objects(scene)
    assert (image[~target.mask] == 255).all()
    painted = {tuple(colour) for colour in scene.style[source.mask]}
    assert {tuple(colour) for colour in image[target.mask]} <= painted


def test_a_sphere_lights_itself_where_its_normals_are_its_own(sphere):
    """A few pixels share a normal on 8 bits; they are neighbours."""
    source, _ = objects(sphere)
    y, x = np.nonzero(source.mask)
    places = normal_table(source)[
        source.normals[y, x, 2] >> 7, source.normals[y, x, 0], source.normals[y, x, 1]
    ]
    across = np.hypot(places // source.mask.shape[1] - y, places % source.mask.shape[1] - x)
    assert np.quantile(across, 0.95) <= 1


def test_styleblit_of_the_sphere_is_the_sphere(sphere):
    """Every seed names its own place, so all pieces fit together."""
    image = StyleBlit(blend=0).run(sphere, 1).image
    mask = objects(sphere)[0].mask
    difference = np.abs(image.astype(int) - sphere.style)[mask].max(axis=1)
    assert (difference == 0).mean() > 0.5
    assert (image[~mask] == 255).all()


def places_of(scene, seed, levels, threshold):
    source, target = objects(scene)
    places = np.full((*target.mask.shape, 2), -1, np.int32)
    assign(*source, *target, normal_table(source), make_jitter(seed), levels, threshold, places)
    return places


def twin(scene, y, x, seed, levels, threshold):
    """The rule of the docstring, one pixel, with all seeds of the picture in a list."""
    source, target = objects(scene)
    table, jitter = normal_table(source), make_jitter(seed)

    def looked_up(at):
        n = target.normals[at]
        return np.array(np.unravel_index(table[n[2] >> 7, n[0], n[1]], source.mask.shape))

    here = np.array([y, x])
    for level in reversed(range(levels)):
        spacing = 2**level
        cells = here // spacing - 1
        seeds = [
            np.floor(spacing * (cell + jitter[tuple(cell % 256)] / 256)).astype(int)
            for cell in (cells + np.array(step) for step in np.ndindex(3, 3))
        ]
        at = min(seeds, key=lambda s: int(((s - here) ** 2).sum()))
        if (at < 0).any() or (at >= target.mask.shape).any() or not target.mask[tuple(at)]:
            continue
        to = looked_up(tuple(at)) + here - at
        if (to < 0).any() or (to >= source.mask.shape).any() or not source.mask[tuple(to)]:
            continue
        error = np.abs(source.normals[tuple(to)].astype(int) - target.normals[y, x]).sum()
        if error < threshold:
            return to.tolist()
    return looked_up((y, x)).tolist()


@pytest.mark.parametrize(("levels", "threshold"), [(7, 24), (3, 60), (1, 0)])
def test_styleblit_takes_the_coarsest_piece_that_fits(scene, levels, threshold):
    places = places_of(scene, 5, levels, threshold)
    ys, xs = np.nonzero(objects(scene)[1].mask)
    for y, x in list(zip(ys, xs, strict=True))[::41]:
        assert places[y, x].tolist() == twin(scene, y, x, 5, levels, threshold)


def test_a_larger_threshold_keeps_larger_pieces(scene):
    mask = objects(scene)[1].mask

    def pieces(threshold):
        places = places_of(scene, 0, 7, threshold)
        together = mask[:, 1:] & mask[:, :-1]
        step = places[:, 1:] - places[:, :-1]
        return (step[together] == (0, 1)).all(axis=1).mean()

    assert pieces(8) < pieces(24) < pieces(64)


def test_styleblit_has_the_same_bytes_again_and_others_with_another_seed(scene):
    images = [StyleBlit().run(scene, seed).image for seed in (3, 3, 4)]
    np.testing.assert_array_equal(images[0], images[1])
    assert (images[0] != images[2]).any()


@pytest.mark.parametrize("method", [LitSphere(), StyleBlit()])
def test_without_normals_the_refusal_names_them(method):
    scene = load_scene("golem/oil", step=6)
    with pytest.raises(InputError, match=r"^golem_oil: was read without NORMAL and IDMASK"):
        method.run(scene, 0)


def test_a_scene_without_an_object_is_refused(scene):
    ids = tuple(np.zeros_like(image) for image in scene.buffers["IDMASK"])
    bare = replace(scene, buffers=scene.buffers | {"IDMASK": ids})
    with pytest.raises(InputError, match="shows no object, which is red in IDMASK"):
        LitSphere().run(bare, 0)
