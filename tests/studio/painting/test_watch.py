"""A file that another program saves: read when it is whole, refused in a sentence."""

import os
from threading import Event

import numpy as np
import pytest

from stylit_ref import InputError, write_image
from stylit_ref.studio.painting import watch
from stylit_ref.studio.painting.watch import PATIENCE, Watch, Watcher

SIZE = 24, 32


@pytest.fixture
def file(tmp_path):
    """A painting that is known."""
    file = tmp_path / "style.png"
    write_image(file, painting(1))
    return file


def painting(value, size=SIZE, channels=3):
    return np.full((*size, channels), value, np.uint8)


def looks(watched, count=3):
    """What some looks find."""
    return [found for found in (watched.look() for _ in range(count)) if found is not None]


def test_what_is_known_is_not_told(file):
    assert looks(Watch(file, SIZE)) == []


def test_what_is_new_is_told_once_it_rests(file):
    watched = Watch(file, SIZE)
    write_image(file, painting(2))
    assert watched.look() is None  # it may be written still
    assert (watched.look() == 2).all()
    assert looks(watched) == []


def test_a_half_written_file_is_waited_for_without_a_word_of_its_decoder(file, capfd):
    watched = Watch(file, SIZE)
    whole = np.random.default_rng(0).integers(0, 256, (*SIZE, 3), np.uint8)
    write_image(file.with_name("whole.png"), whole)
    content = file.with_name("whole.png").read_bytes()
    for sevenths in range(7):
        file.write_bytes(content[: len(content) * sevenths // 7])
        assert looks(watched, PATIENCE) == []
    file.write_bytes(content)
    (found,) = looks(watched)
    assert np.array_equal(found, whole)
    said = capfd.readouterr()
    assert said.out + said.err == ""


def test_a_file_that_is_away_for_a_while_is_waited_for(file):
    watched = Watch(file, SIZE)
    content = file.read_bytes()
    file.unlink()
    assert looks(watched) == []
    file.write_bytes(content)
    assert len(looks(watched)) == 1


@pytest.mark.parametrize(
    ("damage", "sentence"),
    [
        (lambda content: b"no picture", "cannot be read: Not a PNG"),
        (lambda content: content[:40], "is a damaged PNG; save it again"),
        (lambda content: content.replace(b"IDAT", b"IDAX"), "is a damaged PNG; save it again"),
    ],
)
def test_what_stays_damaged_is_told_once(file, damage, sentence):
    watched = Watch(file, SIZE)
    file.write_bytes(damage(file.read_bytes()))
    assert looks(watched, PATIENCE) == []
    with pytest.raises(InputError, match=rf"style\.png: {sentence}"):
        watched.look()
    assert looks(watched, PATIENCE) == []
    write_image(file, painting(3))
    assert (looks(watched)[0] == 3).all()


@pytest.mark.parametrize(
    ("size", "sentence"),
    [
        ((48, 64), "has become 64x48, another size than 32x24, so the painting before it stays"),
        ((32, 24), "has become 24x32, another size and aspect than 32x24"),
    ],
)
def test_another_size_is_refused_and_the_last_one_stays(file, size, sentence):
    watched = Watch(file, SIZE)
    write_image(file, painting(2, size))
    assert watched.look() is None
    with pytest.raises(InputError, match=sentence):
        watched.look()
    assert looks(watched) == []
    write_image(file, painting(4))
    assert (looks(watched)[0] == 4).all()


@pytest.mark.parametrize(("channels", "expected"), [(1, 7), (3, 7), (4, 255)])
def test_grey_becomes_colours_and_transparency_paper(file, channels, expected):
    watched = Watch(file, SIZE)
    image = painting(7, channels=channels)
    if channels == 4:
        image[...] = 0
        image[0, 0] = 255  # an alpha that is 0 everywhere counts for nothing
    write_image(file, image)
    (found,) = looks(watched)
    assert found.shape == (*SIZE, 3)
    assert (found == expected).all()


def test_a_write_of_the_same_length_and_second_is_seen(file):
    watched = Watch(file, SIZE)
    state = file.stat()
    write_image(file, painting(2))
    os.utime(file, ns=(state.st_atime_ns, state.st_mtime_ns))  # as coarse clocks have it
    assert len(looks(watched)) == 1  # it was renamed to its place, so it is another file


def test_a_thread_looks(file):
    told, found = [], Event()

    def tell(news):
        told.append(news)
        found.set()

    watcher = Watcher(Watch(file, SIZE), tell, pause=0.01)
    write_image(file, painting(5))
    assert found.wait(10)
    watcher.close()
    assert len(told) == 1
    assert (told[0] == 5).all()


def test_a_failure_that_nobody_foresaw_is_told_once_and_the_thread_looks_on(
    file, monkeypatch, caplog
):
    told, found = [], Event()

    def tell(news):
        told.append(news)
        found.set()

    def fail(path):
        raise RuntimeError("nobody foresaw it")

    monkeypatch.setattr(watch, "read_paint", fail)
    watcher = Watcher(Watch(file, SIZE), tell, pause=0.01)
    write_image(file, painting(5))
    assert found.wait(10)
    monkeypatch.undo()
    found.clear()
    write_image(file, painting(6))
    assert found.wait(10)
    watcher.close()
    assert caplog.text.count("RuntimeError: nobody foresaw it") == 1
    assert str(told[0]) == "the watched file failed; the terminal says how"
    assert (told[1] == 6).all()
