"""RUN folders: written, read, replayed, damaged."""

import json
from pathlib import Path

import jsonschema
import numpy as np
import pytest
from small_shot import EFFORT, sliding

from stylit_ref import (
    ArrayShot,
    Coherence,
    FrameResult,
    InputError,
    Params,
    Run,
    replay_run,
    stylize_views,
)
from stylit_ref.files.npy_file import write_arrays
from stylit_ref.views.problem import make_problem
from stylit_ref.views.run_folder import digest_of
from stylit_ref.views.run_writer import RunWriter

SCHEMA = Path(__file__).parents[2] / "docs" / "run.schema.json"


def written(folder, names=("0 0", "0/1"), **sizes):
    """A RUN of two frames, its arguments and its results."""
    scene = sliding(frames=2, **sizes)
    shot = ArrayShot(scene.guides, scene.edges, names)
    arguments = scene.style, scene.sources, shot, Params(**EFFORT), Coherence(weight=0.25)
    problem = make_problem(*arguments, seed=3)
    writer = RunWriter(folder, problem, grid=(1, 2), cameras=[{"azimuth": k} for k in range(2)])
    results = list(stylize_views(*arguments, seed=3))
    for result in results:
        writer.add(result)
    return writer.finish(), scene, results


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    return written(tmp_path_factory.mktemp("run"))


@pytest.fixture
def damaged(tmp_path):
    run, _, _ = written(tmp_path)
    return run


def test_a_run_comes_back(made):
    run, scene, results = made
    assert run.names == ("0 0", "0/1")
    assert (run.size, run.grid) == ((38, 44), (1, 2))
    assert run.cameras == ({"azimuth": 0}, {"azimuth": 1})
    assert (run.params, run.seed) == (Params(**EFFORT), 3)
    assert run.coherence == Coherence(weight=0.25)
    assert np.array_equal(run.style(), scene.style)
    for found, guide in zip(run.source_guides(), scene.sources, strict=True):
        assert np.array_equal(found, guide)
    for result in results:
        assert np.array_equal(run.picture(result.frame), result.image)
        assert np.array_equal(run.field(result.frame).nnf, result.nnf)
    assert run.pairs == tuple(scene.edges)
    for pair, motion in scene.edges.items():
        assert np.array_equal(run.motion(*pair).field, motion.field)
        assert np.array_equal(run.motion(*pair).visible, motion.visible)


def test_a_run_of_version_1_is_still_read(damaged):
    run, motion = damaged, damaged.motion(1, 0)
    edge = next(each for each in run.facts["motion"] if each["to"] == 1)
    edge["file"] = "motion/old.npy"
    write_arrays(run.folder / edge["file"], list(motion))
    run.facts["version"] = 1
    run.facts["digests"][edge["file"]] = digest_of(run.folder / edge["file"])
    (run.folder / "run.json").write_text(json.dumps(run.facts), encoding="utf-8")
    found = Run(run.folder).motion(1, 0)
    assert np.array_equal(found.field, motion.field)
    assert np.array_equal(found.visible, motion.visible)


def test_its_facts_follow_the_schema(made):
    jsonschema.validate(made[0].facts, json.loads(SCHEMA.read_text()))


@pytest.mark.parametrize("votes", [None, 2, (1, 2)])
def test_votes_of_frames_that_follow_come_back(made, tmp_path, votes):
    facts = json.loads(json.dumps(made[0].facts))
    facts["coherence"] |= {"order": "sequential", "following_votes": votes}
    (tmp_path / "run.json").write_text(json.dumps(facts))
    written_facts = json.loads((tmp_path / "run.json").read_text())
    jsonschema.validate(written_facts, json.loads(SCHEMA.read_text()))
    assert Run(tmp_path).coherence.following_votes == votes


def test_a_run_of_an_earlier_program_tells_no_votes_of_frames_that_follow(made, tmp_path):
    facts = json.loads(json.dumps(made[0].facts))
    del facts["coherence"]["following_votes"]
    (tmp_path / "run.json").write_text(json.dumps(facts))
    jsonschema.validate(facts, json.loads(SCHEMA.read_text()))
    assert Run(tmp_path).coherence.following_votes is None


def test_motion_is_read_when_its_frame_is_added(tmp_path):
    scene, read = sliding(frames=2), []

    class Counting(ArrayShot):
        def motion(self, to, other):
            read.append((to, other))
            return super().motion(to, other)

    shot = Counting(scene.guides, scene.edges)
    arguments = scene.style, scene.sources, shot, Params(**EFFORT)
    results = list(stylize_views(*arguments))
    read.clear()
    writer = RunWriter(tmp_path, make_problem(*arguments))
    assert read == []
    writer.add(results[1])
    assert read == [(1, 0)]


def test_names_become_names_of_files(made):
    frames = made[0].facts["frames"]
    assert [frame["nnf"] for frame in frames] == ["nnfs/0_0.npy", "nnfs/0_1.npy"]


def test_names_that_would_collide_become_numbers(tmp_path):
    run, _, _ = written(tmp_path, names=("a/b", "A b"))
    assert [frame["nnf"] for frame in run.facts["frames"]] == ["nnfs/0.npy", "nnfs/1.npy"]


def test_replay_of_its_own_style_gives_its_pictures(made):
    run, _, results = made
    replayed = list(replay_run(run, run.style()))
    assert [each.name for each in replayed] == list(run.names)
    for each, result in zip(replayed, results, strict=True):
        assert np.array_equal(each.image, result.image)


def test_replay_takes_a_larger_style(made):
    run, scene, results = made
    large = scene.style.repeat(2, axis=0).repeat(2, axis=1).astype(np.uint16)
    first = next(replay_run(run.folder, large))
    assert first.image.dtype == np.uint16
    assert np.array_equal(first.image[::2, ::2], results[0].image)


def test_a_style_with_alpha_is_kept_exactly(tmp_path):
    scene = sliding(frames=1, style_channels=4)
    writer = RunWriter(tmp_path, make_problem(scene.style, scene.sources, ArrayShot(scene.guides)))
    blank = FrameResult(
        0, "0", np.zeros((38, 44, 4), np.uint8), np.full((38, 44, 2), 9, np.int32)
    )  # fmt: skip
    writer.add(blank)
    assert np.array_equal(writer.finish().style(), scene.style)


def test_a_run_with_frames_left_out_is_none(tmp_path):
    scene = sliding(frames=2)
    problem = make_problem(scene.style, scene.sources, ArrayShot(scene.guides))
    written(tmp_path)
    with pytest.raises(InputError, match="the frames 0, 1 have not been added; a RUN has all"):
        RunWriter(tmp_path, problem).finish()
    with pytest.raises(InputError, match=r"is no RUN, since it holds no run.json"):
        Run(tmp_path)


def test_a_changed_file_is_told(damaged):
    file = damaged.folder / "nnfs" / "0_1.npy"
    file.write_bytes(file.read_bytes()[:-1])
    with pytest.raises(InputError, match=r"0_1.npy: is not what the run wrote"):
        damaged.field(1)


def test_a_missing_file_is_told(damaged):
    (damaged.folder / "style.png").unlink()
    with pytest.raises(InputError, match=r"style.png: is missing; run.json names it"):
        damaged.style()


@pytest.mark.parametrize(
    ("facts", "said"),
    [
        ("{", "run.json: is no JSON"),
        ("[]", "run.json: is not that of a RUN of this program"),
        ('{"schema": "stylit-ref run", "version": 9}', "is of version 9, and this program reads"),
        ('{"schema": "stylit-ref run", "version": 1}', "lacks facts of a RUN, or holds wrong"),
    ],
)
def test_facts_that_cannot_be_used_are_one_sentence(tmp_path, facts, said):
    (tmp_path / "run.json").write_text(facts)
    with pytest.raises(InputError, match=said):
        Run(tmp_path)


def test_a_run_leaves_no_file_of_the_one_before(tmp_path):
    run, _, _ = written(tmp_path / "run")
    (run.folder / "mine.txt").write_text("kept", encoding="utf-8")
    facts = run.facts | {"digests": run.facts["digests"] | {"../outside.txt": ""}}
    (run.folder / "run.json").write_text(json.dumps(facts), encoding="utf-8")
    (tmp_path / "outside.txt").write_text("kept", encoding="utf-8")
    again, _, _ = written(run.folder, names=("left", "right"))
    there = {each for each in run.folder.rglob("*") if each.is_file()}
    assert there == {*again.files, run.folder / "mine.txt"}
    assert (tmp_path / "outside.txt").exists()


@pytest.mark.parametrize("text", ["[]", "{", '{"schema": "of another program"}'])
def test_the_run_file_of_another_program_is_not_replaced(tmp_path, text):
    (tmp_path / "run.json").write_text(text, encoding="utf-8")
    with pytest.raises(InputError, match="is not that of a RUN; name another folder"):
        written(tmp_path)
    assert (tmp_path / "run.json").read_text(encoding="utf-8") == text


def test_what_a_run_has_not_is_refused(made):
    run, _, _ = made
    for read in (run.picture, run.field):
        for frame in (-1, 2):
            with pytest.raises(InputError, match=f"has no frame {frame}; its frames are 0 to 1"):
                read(frame)
    with pytest.raises(InputError, match=r"has no motion from frame 1 into frame 7; its pairs are"):
        run.motion(1, 7)


def test_a_file_that_cannot_be_removed_is_told(tmp_path):
    (tmp_path / "pictures").mkdir()
    facts = {"schema": "stylit-ref run", "digests": {"pictures": ""}}
    (tmp_path / "run.json").write_text(json.dumps(facts), encoding="utf-8")
    with pytest.raises(InputError, match=r"pictures: cannot be removed: "):
        written(tmp_path)
