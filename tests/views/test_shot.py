"""Shots in memory and of files."""

import pickle
from dataclasses import dataclass, replace

import numpy as np
import pytest
from small_shot import EFFORT, sliding

from stylit_ref import (
    ArrayShot,
    FileShot,
    GuideEncoding,
    InputError,
    Motion,
    Params,
    stylize_frames,
    stylize_views,
    write_image,
)
from stylit_ref.views.file_shot import files_digest
from stylit_ref.views.problem import make_problem
from stylit_ref.views.work.keys import keys_of

PARAMS = Params(**EFFORT)


@dataclass(frozen=True)
class Saved:
    """Motion as numpy.save writes it."""

    path: str

    def read(self):
        field = np.load(self.path)
        return Motion(field, np.ones(field.shape[:2], bool))

    def digest(self):
        return files_digest([self.path])


@pytest.fixture
def scene():
    return sliding(frames=2)


@pytest.fixture
def files(tmp_path, scene):
    """The scene on the disk."""
    paths, motion = [], {}
    for frame, guides in enumerate(scene.guides):
        paths.append(tuple(str(tmp_path / f"{frame}_{k}.png") for k in range(len(guides))))
        for path, guide in zip(paths[-1], guides, strict=True):
            write_image(path, guide)
    for (to, other), each in scene.edges.items():
        motion[to, other] = Saved(str(tmp_path / f"{to}_{other}.npy"))
        np.save(motion[to, other].path, each.field)
    size = scene.guides[0][0].shape[:2]
    encodings = (GuideEncoding("data"), GuideEncoding("data"))
    return FileShot(("a", "b"), size, tuple(paths), encodings, (3, 1), motion)


def test_files_give_the_bytes_of_arrays(scene, files):
    shot = pickle.loads(pickle.dumps(files))
    of_files = list(stylize_views(scene.style, scene.sources, shot, PARAMS))
    edges = scene.edges
    of_arrays = list(stylize_views(scene.style, scene.sources, scene.guides, PARAMS, edges=edges))
    assert [result.name for result in of_files] == ["a", "b"]
    for one, other in zip(of_files, of_arrays, strict=True):
        assert np.array_equal(one.image, other.image)
        assert np.array_equal(one.nnf, other.nnf)


def test_a_digest_is_of_what_files_hold(files, scene):
    before = files.guides_digest(0), files.guides_digest(1), files.motion_digest(0, 1)
    scene.guides[1][0][0, 0] ^= 1
    write_image(files.guide_files[1][0], scene.guides[1][0])
    after = files.guides_digest(0), files.guides_digest(1), files.motion_digest(0, 1)
    assert [one == other for one, other in zip(before, after, strict=True)] == [True, False, True]


def test_files_that_change_after_their_digest_was_taken_are_refused(files, scene):
    """Also in another process, which has a copy of the shot."""
    files.guides_digest(1)
    files.motion_digest(0, 1)
    elsewhere = pickle.loads(pickle.dumps(files))
    scene.guides[1][0][0, 0] ^= 1
    write_image(files.guide_files[1][0], scene.guides[1][0])
    np.save(files.motion_sources[0, 1].path, 2 * scene.edges[0, 1].field)
    for shot in (files, elsewhere):
        with pytest.raises(InputError, match=r"frame b: one of its files has changed since .*1_0"):
            shot.guides(1)
        with pytest.raises(InputError, match=r"the motion from frame a into frame b: one of its"):
            shot.motion(0, 1)
        shot.guides(0)
        shot.motion(1, 0)
    files.guides_digest(1)
    files.guides(1)


def test_no_state_is_kept_of_a_frame_that_changes_as_the_run_goes_on(files, scene, tmp_path):
    before = scene.guides[1][0].copy()

    def change(step):
        if step.frame == 0:
            scene.guides[1][0][0, 0] = 255 - before[0, 0]
            write_image(files.guide_files[1][0], scene.guides[1][0])

    def results(**more):
        return stylize_frames(
            scene.style, scene.sources, files, PARAMS, work=tmp_path / "work", **more
        )

    with pytest.raises(InputError, match="frame b: one of its files has changed"):
        list(results(progress=change))
    write_image(files.guide_files[1][0], before)
    scene.guides[1][0] = before
    again = list(results())
    edges = scene.edges
    of_arrays = stylize_frames(scene.style, scene.sources, scene.guides, PARAMS, edges=edges)
    for one, other in zip(again, of_arrays, strict=True):
        assert np.array_equal(one.nnf, other.nnf)


def test_a_grey_frame_is_spread_to_the_colours_of_the_source(files, scene):
    write_image(files.guide_files[0][0], scene.guides[0][1])
    assert np.array_equal(files.guides(0)[0], scene.guides[0][1].repeat(3, axis=2))


def test_a_frame_in_colour_beside_a_grey_source_is_refused(files, scene):
    write_image(files.guide_files[0][1], scene.guides[0][0])
    with pytest.raises(InputError, match=r"0_1.png: has 3 channels but the source's guide has 1;"):
        files.guides(0)


def test_a_frame_file_of_another_size_is_refused(files, scene):
    write_image(files.guide_files[1][0], scene.guides[1][0][1:])
    with pytest.raises(InputError, match=r"1_0.png: is 44x37 but the other frames are 44x38;"):
        list(stylize_views(scene.style, scene.sources, files, PARAMS))


def test_names_are_different(scene):
    with pytest.raises(InputError, match="names holds 1 different names for 2 frames"):
        ArrayShot(scene.guides, names=["a", "a"])


def test_edges_of_a_shot_are_its_own(scene):
    shot = ArrayShot(scene.guides, scene.edges)
    with pytest.raises(InputError, match="edges are those of the shot; leave them out"):
        stylize_views(scene.style, scene.sources, shot, PARAMS, edges=scene.edges)


def test_guides_that_do_not_fit_the_source_are_refused_at_once(scene):
    guides = [each[:1] for each in scene.guides]
    with pytest.raises(InputError, match="target_guides holds 1 guides but source_guides holds 2"):
        stylize_views(scene.style, scene.sources, guides, PARAMS)


def test_the_code_of_a_shot_is_also_that_which_reads_its_motion(files):
    assert replace(files, motion_sources={}).code != files.code


def test_a_state_belongs_to_the_code_that_read_its_frame(scene, files, monkeypatch):
    problem = make_problem(scene.style, scene.sources, files, PARAMS)
    before = keys_of(problem, problem.plan())
    monkeypatch.setattr(FileShot, "code", "other")
    after = keys_of(problem, problem.plan())
    assert not set(before.values()) & set(after.values())
