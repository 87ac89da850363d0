"""What is wrong with the files of a shot, in one message."""

import pytest

from stylit_ref import InputError
from stylit_ref.cli.shot_problems import ShotProblems


@pytest.fixture
def shot(tmp_path):
    """Three files of a pattern with two layers each, and a source: (folder, problems)."""
    problems = ShotProblems()
    for frame in (1, 2, 3):
        (tmp_path / f"a.{frame}.exr").touch()
        for layer in "XY":
            problems.patterns[f"{tmp_path}/a.{frame}.exr:{layer}"] = f"{tmp_path}/a.%d.exr:{layer}"
    (tmp_path / "source.exr").touch()
    return tmp_path, problems


def said(problems):
    with pytest.raises(InputError) as refusal:
        problems.refuse()
    return str(refusal.value)


def add(problems, folder, frame, layer):
    file = f"{folder}/a.{frame}.exr"
    problems.add(f"{file}: is broken", f"{file}:{layer}")


def test_nothing_is_refused_without_problems(shot):
    shot[1].refuse()
    shot[1].add_missing([f"{shot[0]}/source.exr", str(shot[0])])
    shot[1].refuse()


def test_what_all_files_have_is_said_of_the_pattern(shot):
    folder, problems = shot
    for frame in (1, 2, 3):
        for layer in "XY":
            add(problems, folder, frame, layer)
    assert said(problems) == f"{folder}/a.%d.exr: is broken"


def test_what_some_files_have_names_them(shot):
    folder, problems = shot
    for frame in (1, 3):
        add(problems, folder, frame, "X")
    assert said(problems) == (
        f"{folder}/a.%d.exr: is broken (in {folder}/a.1.exr, {folder}/a.3.exr)"
    )


def test_what_one_file_has_names_it_alone(shot):
    folder, problems = shot
    for layer in "XY":
        add(problems, folder, 2, layer)
    assert said(problems) == f"{folder}/a.2.exr: is broken"


def test_a_file_of_no_pattern_is_named_once(shot):
    folder, problems = shot
    for layer in "XY":
        problems.add(f"{folder}/source.exr: is broken", f"{folder}/source.exr:{layer}")
    assert said(problems) == f"{folder}/source.exr: is broken"


def test_missing_files_are_named_at_once(shot):
    folder, problems = shot
    problems.add_missing([f"{folder}/b.png"])
    assert said(problems) == f"{folder}/b.png: no such file"
    problems.add_missing([f"{folder}/{name}.png" for name in ("c", "d", "c")])
    assert said(problems).endswith(f"; no such files: {folder}/c.png, {folder}/d.png")


def test_no_more_than_eight_are_named(shot):
    folder, problems = shot
    problems.add_missing([f"{folder}/{number}.png" for number in range(10)])
    assert said(problems).endswith("7.png and 2 more")
    for number in range(9):
        problems.add(f"problem {number}")
    assert said(problems).endswith("problem 6; and 2 more")
