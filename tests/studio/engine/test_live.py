"""The picture that follows: the newest wins, and nothing painted is lost."""

from threading import Event

import numpy as np
import pytest
from small_studio import SIZE, Ears, make_painting, make_scene

from stylit_ref.errors import InputError
from stylit_ref.realtime.session import FrameCancelledError
from stylit_ref.studio.engine import worker
from stylit_ref.studio.engine.events import Exported, Picture, Problem, Stepped
from stylit_ref.studio.engine.follower import Follower
from stylit_ref.studio.engine.live import Live
from stylit_ref.studio.engine.scene import Scene

STROKE = np.full((6, 5, 3), 250, np.uint8)


class NoBackground:
    """In place of the process: remembers the wishes, and is busy until one is given up."""

    def __init__(self, tell, made):
        self.made, self.wishes, self.is_busy = made, [], False

    def begin(self, wish):
        self.wishes.append(wish)
        self.is_busy = True

    def cancel(self):
        self.is_busy = False

    def compile_ahead(self, params, packing):
        pass

    def close(self):
        pass


@pytest.fixture
def background(monkeypatch):
    """The backgrounds that were made."""
    made = []

    def make(*arguments):
        made.append(NoBackground(*arguments))
        return made[-1]

    monkeypatch.setattr(worker, "Background", make)
    return made


@pytest.fixture
def ears():
    return Ears()


@pytest.fixture
def live(background, ears):
    live = Live(make_scene(3), make_painting(), tell=ears, threads=1, seed=3)
    yield live
    live.close()


@pytest.fixture
def begun(live, ears):
    """After the first picture, and all that follows it."""
    ears.picture("coherent")
    live.look("style")
    ears.picture("look")
    return live


class Gate:
    """Frames wait until it opens, or until they are cancelled."""

    def __init__(self, monkeypatch):
        self.entered, self._left = Event(), Event()
        self._is_cancelled = False
        frame, cancel = Follower.frame, Follower.cancel

        def wait(follower, *, warm):
            self.entered.set()
            assert self._left.wait(60)
            if self._is_cancelled:
                self._is_cancelled = False
                self._left.clear()
                raise FrameCancelledError
            return frame(follower, warm=warm)

        def heed(follower):
            self._is_cancelled = True
            self._left.set()
            cancel(follower)

        monkeypatch.setattr(Follower, "frame", wait)
        monkeypatch.setattr(Follower, "cancel", heed)

    def open(self):
        self._left.set()


def test_a_stroke_is_replayed_at_once_and_coherent_after_a_rest(begun, ears, background):
    begun.paint(3, 4, STROKE, 7)
    assert ears.picture("replay").serial == 7
    begun.rest()
    assert ears.picture("coherent").serial == 7
    begun.look("style")
    painted = make_painting()
    painted[4:10, 3:8] = STROKE
    assert np.array_equal(ears.picture("look").image, painted)
    wishes = background[0].wishes
    assert [(wish.which, wish.serial) for wish in wishes] == [("fast", 0), ("fast", 7)]
    assert np.array_equal(wishes[1].style, painted)


def test_no_rectangle_is_lost(begun, ears):
    random, painted = np.random.default_rng(0), make_painting()
    for serial in range(1, 201):
        height, width = random.integers(1, 9, 2)
        y, x = random.integers(0, SIZE[0] - height), random.integers(0, SIZE[1] - width)
        pixels = random.integers(0, 256, (height, width, 3), np.uint8)
        begun.paint(x, y, pixels, serial)
        painted[y : y + height, x : x + width] = pixels
        if serial % 20 == 0:
            begun.rest()
    ears.next(Picture, serial=200)
    begun.look("style")
    assert np.array_equal(ears.picture("look").image, painted)


def test_a_stroke_ends_the_frame_before_it(begun, ears, monkeypatch):
    gate = Gate(monkeypatch)
    begun.paint(3, 4, STROKE, 1)
    begun.rest()
    assert gate.entered.wait(60)
    begun.paint(9, 4, STROKE, 2)
    while ears.picture("replay").serial != 2:
        pass
    gate.open()
    begun.rest()
    assert ears.picture("coherent").serial == 2


def test_strokes_do_not_end_the_first_frame(background, ears, monkeypatch):
    gate = Gate(monkeypatch)
    live = Live(make_scene(), make_painting(), tell=ears, threads=1)
    assert gate.entered.wait(60)
    live.paint(3, 4, STROKE, 1)
    gate.open()
    assert ears.picture("coherent").serial == 0
    assert ears.picture("replay").serial == 1
    live.close()


def test_what_waits_while_the_thread_is_busy_is_no_more_than_two_paintings(
    begun, ears, monkeypatch
):
    gate = Gate(monkeypatch)
    begun.set_seed(4)
    assert gate.entered.wait(60)
    monkeypatch.setattr(Follower, "cancel", lambda follower: None)  # as while a kernel is compiled
    painted = make_painting()
    for serial in range(1, 101):
        painted = make_painting(serial)
        begun.paint(0, 0, painted, serial)
        painted[4:10, 3:8] = STROKE
        begun.paint(3, 4, STROKE, serial)
    waiting = begun._worker._waiting
    assert sum(pixels.nbytes for _, _, pixels, _ in waiting._rectangles) <= 2 * painted.nbytes
    gate.open()
    ears.next(Picture, serial=100)
    begun.look("style")
    assert np.array_equal(ears.picture("look").image, painted)


def test_a_change_gives_up_what_the_background_made(begun, ears, background):
    made = object()
    background[0].made(made)
    assert begun._worker.shown() is made
    begun.paint(3, 4, STROKE, 1)
    assert not background[0].is_busy
    ears.picture("replay")
    assert begun._worker.shown().which == "replay"


def test_a_rest_without_a_change_makes_nothing(begun, ears, background):
    begun.rest()
    begun.look("style")
    ears.picture("look")
    assert len(background[0].wishes) == 1


def test_the_full_method_is_wished_for(begun, ears, background):
    begun.finish()
    begun.look("style")
    ears.picture("look")
    assert background[0].wishes[-1].which == "full"


def test_another_scene_is_painted_at_its_own_size(begun, ears):
    other = make_scene()
    other = type(other)("other", "Other", other.target(0), [lambda: make_scene().source])
    with pytest.raises(InputError, match="Other is painted at 41x37 pixels"):
        begun.choose_scene(other)
    begun.choose_scene(other, np.zeros((37, 41, 3), np.uint8), 5)
    picture = ears.picture("coherent")
    assert picture.serial == 5
    assert picture.image.shape == (*SIZE, 3)
    assert not picture.image.any()


def test_a_turn_is_warm_cold_or_waits(begun, ears):
    begun.turn(1, warm=True)
    ears.picture("warm")
    begun.turn(2, warm=False)
    cold = ears.picture("coherent").image
    begun.turn(1, warm=True, restylize=False)
    begun.look("B:FULL")
    assert np.array_equal(ears.picture("look").image, make_scene(3).target(1)["FULL"])
    begun.rest()
    assert not np.array_equal(ears.picture("coherent").image, cold)


@pytest.mark.parametrize(
    ("method", "argument"),
    [
        ("set_parameters", {"levels": 3}),
        ("set_weights", {"LSE": 5}),
        ("set_seed", 9),
        ("replace_painting", make_painting(1)),
    ],
)
def test_what_is_set_is_seen(begun, ears, method, argument):
    begun.look("level:0")
    before = ears.picture("look").image
    more = (4,) if method == "replace_painting" else ()
    getattr(begun, method)(argument, *more)
    assert not np.array_equal(ears.picture("coherent").image, before)


def test_parameters_of_the_dense_method_are_for_the_background(begun, ears, background):
    begun.set_parameters({"uniformity": 77})
    begun.look("style")
    assert ears.next(Picture).which == "look"
    assert background[0].wishes[-1].settings.dense.uniformity == 77


def test_steps_end_in_the_coherent_picture(background, ears):
    live = Live(make_scene(), make_painting(), tell=ears, threads=1)
    coherent = ears.picture("coherent").image
    live.step("pyramid")
    for _ in range(6):
        live.step("level")
    while not ears.next(Stepped).done:
        last = ears.picture("step").image
    assert np.array_equal(last, coherent)
    live.close()


def test_steps_restart_when_the_scene_changes(begun, ears):
    begun.step("pyramid")
    assert "upsample" in ears.next(Stepped).possible
    begun.turn(1, warm=True)
    assert ears.next(Stepped).possible == ("restart", "pyramid")
    begun.step("upsample")
    assert ears.next(Problem).text.startswith("upsample is not what comes next; possible are")


def test_an_export_says_its_files(begun, ears, tmp_path):
    begun.export(lambda: tmp_path / "new")
    files = ears.next(Exported).files
    assert all((tmp_path / "new" / file).is_file() for file in files)


@pytest.mark.parametrize(
    "what",
    ["style", "A:FULL", "B:FRESNEL", "level:2", "nnf", "usage"],
)
def test_there_is_much_to_look_at(begun, ears, what):
    begun.look(what)
    image = ears.next(Picture, which="look", of=what).image
    assert image.dtype == np.uint8
    assert image.shape[2] == 3
    assert image.any()


@pytest.mark.parametrize(
    ("what", "sentence"),
    [
        ("A:NONE", "no buffer is called 'NONE'; there are FULL, LDE"),
        ("level:6", "level is 6; it must be an integer from 0 to 5"),
        ("level:-1", "nothing is called 'level:-1' to look at"),
        ("", "nothing is called '' to look at"),
    ],
)
def test_what_cannot_be_looked_at_is_told_and_life_goes_on(begun, ears, what, sentence):
    begun.look(what)
    assert sentence in ears.next(Problem, of=what).text
    begun.paint(3, 4, STROKE, 1)
    ears.picture("replay")


@pytest.mark.parametrize(
    ("method", "arguments", "sentence"),
    [
        ("paint", (32, 4, STROKE, 1), "pixels are 5x6 at x 32, y 4, and the painting is 36x40"),
        ("paint", (-1, 4, STROKE, 1), "they must lie in it"),
        ("paint", (0, 0, STROKE[..., :1], 1), "it must be height, width and 3 colours"),
        ("replace_painting", (np.zeros((9, 8, 3), np.uint8), 1), "painting is 8x9, but A small"),
        ("replace_painting", (np.zeros((40, 36, 3)), 1), "painting has the shape"),
        ("set_parameters", ({"levels": 0},), "levels is 0; it must be an integer from 1 to 12"),
        ("set_weights", ({"NONE": 1},), "no buffer is called 'NONE'"),
        ("set_seed", (-1,), "seed is -1; it must be an integer"),
        ("step", ("jump",), "operation is 'jump'; it must be"),
    ],
)
def test_what_cannot_be_is_refused_at_once(live, method, arguments, sentence):
    with pytest.raises(InputError, match=sentence):
        getattr(live, method)(*arguments)


def test_settings_that_cannot_be_are_refused_at_once(begun):
    begun.set_weights(dict.fromkeys(make_scene().buffers, 2))
    with pytest.raises(InputError, match="weights are too large for patches of this width"):
        begun.set_parameters({"patch_width": 13, "mu": [5]})


def test_a_packing_wants_its_buffers(background, ears):
    stage, names = make_scene(), ("FULL", "IDMASK")
    source, target = ({name: side[name] for name in names}
                      for side in (stage.source, stage.target(0)))  # fmt: skip
    scene = Scene("plain", "Plain", source, [lambda: target])
    live = Live(scene, make_painting(), tell=ears, threads=1)
    with pytest.raises(InputError, match="packing is 'packed', which also needs LDE"):
        live.set_parameters({"packing": "packed"})
    live.close()


def test_there_is_no_such_step_of_the_target(live):
    with pytest.raises(InputError, match="step is 3; it must be an integer from 0 to 2"):
        live.turn(3, warm=True)


def test_a_scene_that_cannot_be_stylized_is_told(begun, ears):
    mask = np.full((37, 41, 3), (0, 0, 255), np.uint8)
    scene = make_scene(LIGHTMASK=mask)
    scene.source["LIGHTMASK"][:] = (0, 255, 0)
    begun.choose_scene(scene)
    assert "a thing that is not in what you paint on" in ears.next(Problem).text
    begun.set_parameters({"labels": False})
    ears.picture("coherent")


def test_nothing_is_told_after_the_end(begun, ears):
    begun.close()
    begun.paint(3, 4, STROKE, 1)
    assert ears.all() == []
