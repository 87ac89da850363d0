"""Any input gives a result with the promised properties, or one sentence that names the fault."""

import io
import json
import math
import warnings
from contextlib import redirect_stderr
from dataclasses import asdict
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
from hostile.generated import generated
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from small_scene import small_scene

from data_gen.manifest import DataError, Manifest
from eval.runs.store import read
from stylit_ref import InputError, Params, read_image, replay, stylize, write_image
from stylit_ref.cli import main
from stylit_ref.files.disk.paths import check_writable
from stylit_ref.formulae.guide_map import patch_sum, scaled_variance, variance_limit
from stylit_ref.formulae.rounding import rounded_mean
from stylit_ref.metric.packing import ONE, make_packing, occurrence_weight
from stylit_ref.randomness.philox import uniform_below
from stylit_ref.stylization.synthesis import Synthesis

DTYPES = ("uint8", "uint16", "int16", "int32", "float32", "float64", "bool", "object", ">i4", "U1")


def refusal(call, *arguments, **options):
    """Call a function: returns (result, None), or (None, sentence) if the input is refused.

    There are no warnings: the library's own notes are records of its logger.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            return call(*arguments, **options), None
        except InputError as error:
            sentence = str(error)
    assert sentence
    assert sentence.isprintable()
    assert "Traceback" not in sentence
    return None, sentence


# Parameters

NUMBERS = st.one_of(
    st.integers(-2, 70),
    st.integers(-(10**40), 10**40),
    st.floats(),
    st.booleans(),
    st.fractions(max_denominator=9),
    st.integers(-5, 20).map(np.int64),
    st.floats(width=32).map(np.float32),
    st.floats(0, 2).map(np.float64),
)
ODDITIES = st.one_of(
    st.none(),
    st.text(max_size=4),
    st.binary(max_size=4),
    st.just(1j),
    st.just(Decimal("0.5")),
    st.just(np.bool_(True)),
    st.just({}),
    st.lists(NUMBERS, max_size=4),
    st.lists(st.lists(st.integers(1, 5), max_size=2), max_size=3),
    hnp.arrays(st.sampled_from([np.int64, np.float64, np.bool_]), hnp.array_shapes(max_dims=2)),
)
VALID = {
    "method": st.sampled_from(["ref", "guide_map", "stylit"]),
    "patch_width": st.sampled_from([3, 5, 7, 63]),
    "levels": st.integers(1, 16),
    "votes": st.one_of(st.integers(1, 65535), st.lists(st.integers(1, 9), min_size=1, max_size=4)),
    "patchmatch_iterations": st.integers(1, 65535),
    "uniformity": st.floats(0, 1e12),
    "guide_influence": st.floats(0, 1e12),
    "guide_weights": st.one_of(st.none(), st.lists(st.floats(0, 1e12), max_size=4)),
    "schedule": st.just("propose_commit"),
    "vote_outliers": st.integers(0, 8),
    "epsilon": st.floats(0, 1e12),
    "budget": st.one_of(st.just("hyperbola"), st.floats(0.01, 1)),
    "fixed_share": st.floats(0.01, 1),
    "error_limit": st.one_of(st.none(), st.floats(1, 1e12)),
}


def only(name):
    return st.one_of(NUMBERS, ODDITIES).map(lambda value: {name: value})


@pytest.mark.slow
@generated(700, change=st.sampled_from(sorted(VALID)).flatmap(only))
def test_a_parameter_is_taken_or_named(change):
    params, sentence = refusal(Params, **change)
    if sentence:
        assert next(iter(change)).removesuffix("s").replace("_", " ") in sentence.replace("_", " ")
    else:
        as_plain_numbers(params)


@pytest.mark.slow
@generated(200, values=st.fixed_dictionaries({}, optional=VALID))
def test_parameters_in_range_are_taken(values):
    as_plain_numbers(Params(**values))


def as_plain_numbers(params):
    """Parameters are plain numbers, so that equal ones have the same key in store and kernels."""
    text = json.dumps(asdict(params), allow_nan=False)
    assert Params(**json.loads(text)) == params
    for name in ("patch_width", "levels", "patchmatch_iterations", "vote_outliers"):
        assert type(getattr(params, name)) is int
    for name in ("uniformity", "guide_influence", "epsilon", "fixed_share"):
        assert type(getattr(params, name)) is float


# The door of stylize


class PassedError(Exception):
    """The input has passed all checks."""


@pytest.fixture
def door(monkeypatch):
    def opened(*_):
        raise PassedError

    monkeypatch.setattr(Synthesis, "begin_level", opened)


SIDES = st.integers(0, 8)
IMAGES = st.one_of(
    st.builds(
        np.zeros,
        st.one_of(
            st.tuples(SIDES, SIDES, st.integers(0, 6)),
            st.tuples(SIDES, SIDES),
            hnp.array_shapes(min_dims=1, max_dims=4, min_side=0, max_side=6),
            st.just(()),
        ),
        st.sampled_from(DTYPES),
    ),
    st.just([[1, 2], [3]]),
    st.just(None),
)


def is_image(array, channels=range(1, 2**31)):
    """Whether it is (H, W) or (H, W, n) uint8 with pixels."""
    if not isinstance(array, np.ndarray) or array.dtype != np.uint8 or not array.size:
        return False
    return array.ndim in (2, 3) and np.atleast_3d(array).shape[2] in channels


def fits(style, source, target, patch_width):
    """What the documentation of stylize asks of a pair of guides."""
    return (
        is_image(style, range(1, 5))
        and is_image(source)
        and is_image(target)
        and source.shape[:2] == style.shape[:2]
        and np.atleast_3d(source).shape[2] == np.atleast_3d(target).shape[2]
        and min(*style.shape[:2], *target.shape[:2]) >= patch_width
    )


@st.composite
def scenes(draw):
    """A style and guides, mostly of one size; one of them may be any array."""
    width = draw(st.sampled_from([3, 5, 7]))
    size = st.tuples(*[st.sampled_from([0, 1, width - 1, width, width + 1, 11])] * 2)
    source_size, target_size, channels = draw(size), draw(size), draw(st.integers(0, 5))
    images = [
        np.zeros((*source_size, draw(st.integers(0, 5))), np.uint8),
        np.zeros((*source_size, channels), np.uint8),
        np.zeros((*target_size, channels), np.uint8),
    ]
    if draw(st.booleans()):
        images[draw(st.integers(0, 2))] = draw(IMAGES)
    return *images, width


@pytest.mark.slow
@generated(700, scene=scenes())
def test_images_pass_the_door_if_they_fit(door, scene):
    style, source, target, width = scene
    try:
        _, sentence = refusal(stylize, style, [source], [target], Params(patch_width=width))
    except PassedError:
        assert fits(*scene)
    else:
        assert not fits(*scene)
        assert any(word in sentence for word in ("style", "guide", "patch_width"))


@pytest.mark.slow
@generated(
    300,
    mask=st.one_of(
        st.none(), IMAGES, st.tuples(st.just((6, 7)), st.booleans()).map(lambda a: np.full(*a))
    ),
    fill=st.one_of(st.none(), IMAGES, st.just(np.zeros((6, 7, 3), np.uint8))),
    seed=st.one_of(st.integers(0, 2**64 - 1), NUMBERS, ODDITIES),
    threads=st.one_of(st.none(), st.just(1), NUMBERS, ODDITIES),
)
def test_masks_seeds_and_threads_pass_the_door_if_they_fit(door, mask, fill, seed, threads):
    guide, style = np.zeros((6, 7), np.uint8), np.zeros((6, 7, 3), np.uint8)
    good_mask = mask is None or (
        isinstance(mask, np.ndarray)
        and mask.dtype == bool
        and mask.shape == (6, 7)
        and not mask.all()
    )
    good_fill = fill is None or (
        is_image(fill) and fill.shape[:2] == (6, 7) and np.atleast_3d(fill).shape[2] <= 4
    )
    good_seed = isinstance(seed, int | np.integer) and 0 <= seed < 2**64
    good_threads = threads is None or (isinstance(threads, int | np.integer) and threads >= 1)
    try:
        options = {"seed": seed, "mask": mask, "fill": fill, "threads": threads}
        _, sentence = refusal(stylize, style, [guide], [guide], Params(levels=1), **options)
    except PassedError:
        assert good_mask
        assert good_fill
        assert good_seed
        assert good_threads
    else:
        assert not (good_mask and good_fill and good_seed and good_threads)
        assert any(word in sentence for word in ("mask", "fill", "seed", "threads"))


# Runs: kernels take seconds to compile, so sizes and values vary; patch width and channels do not


@st.composite
def runs(draw):
    side = st.one_of(st.sampled_from([5, 6]), st.integers(5, 14))
    values = {
        "method": draw(st.sampled_from(["ref", "ref", "guide_map", "stylit"])),
        "levels": draw(st.integers(1, 3)),
        "votes": draw(st.one_of(st.integers(1, 2), st.lists(st.integers(1, 2), min_size=1))),
        "patchmatch_iterations": draw(st.integers(1, 2)),
        "uniformity": draw(st.sampled_from([0, 1, 5e3, 1e7, np.float32(3), Fraction(1, 3)])),
        "guide_influence": draw(st.sampled_from([0, 0.001, 2, 1000])),
        "guide_weights": draw(st.sampled_from([None, (0, 0), (3, 3)])),
        "epsilon": draw(st.sampled_from([0, 100, 1e12])),
    }
    sizes = [(draw(side), draw(side)) for _ in range(2)]
    seed = draw(st.integers(0, 2**64 - 1))
    masked = draw(st.one_of(st.none(), st.integers(0, sizes[1][0] - 1)))
    return Params(**values), sizes, seed, masked


@pytest.mark.slow
@generated(200, run=runs())
def test_a_run_keeps_what_it_promises(run):
    params, (source_size, target_size), seed, masked = run
    scene = small_scene(seed % 5, source_size, target_size)
    mask = None
    if masked is not None:
        mask = np.zeros(target_size, bool)
        mask[:masked] = True
    result, sentence = refusal(stylize, *scene, params, seed=seed, mask=mask)
    if sentence:
        assert "too small to count" in sentence
        assert params.guide_influence == 0.001
        return
    width, radius = params.patch_width, params.patch_width // 2
    assigned = result.nnf[:, :, 0] >= 0
    assert result.image.shape == (*target_size, 3 + (mask is not None))
    assert result.image.dtype == np.uint8
    assert assigned.all() or mask is not None
    centres = result.nnf[assigned]
    assert (centres >= radius).all()
    assert (centres < np.array(source_size) - radius).all()
    assert (result.nnf[~assigned] == -1).all()
    assert result.omega.sum() == width**2 * np.count_nonzero(assigned)
    assert (np.isnan(result.error) == ~assigned).all()
    assert (result.error[assigned] >= 0).all()
    shown, _ = refusal(replay, result.nnf, scene[0], patch_width=width, mask=mask)
    np.testing.assert_array_equal(shown, result.image)
    again, _ = refusal(stylize, *scene, params, seed=seed, mask=mask, threads=1)
    np.testing.assert_array_equal(again.nnf, result.nnf)
    np.testing.assert_array_equal(again.image, result.image)


# Replay


@pytest.mark.slow
@generated(
    250,
    nnf=st.one_of(
        IMAGES,
        hnp.arrays(np.int32, st.tuples(SIDES, SIDES, st.just(2)), elements=st.integers(-2, 7)),
        hnp.arrays(np.int32, st.just((4, 3, 2)), elements=st.integers(1, 3)).map(np.asfortranarray),
    ),
    style=st.one_of(
        IMAGES,
        hnp.arrays(
            st.sampled_from(["uint8", "uint16", "float32"]),
            st.tuples(st.integers(4, 8), st.integers(4, 8), st.integers(1, 3)),
            elements=st.integers(0, 200),
        ),
    ),
    patch_width=st.one_of(st.sampled_from([1, 3]), NUMBERS),
    scale=st.one_of(st.sampled_from([1, 2]), NUMBERS),
)
def test_a_replay_is_of_the_style_or_refused(nnf, style, patch_width, scale):
    image, sentence = refusal(replay, nnf, style, patch_width=patch_width, scale=scale)
    if sentence:
        assert any(word in sentence for word in ("nnf", "style", "patch_width", "scale"))
        return
    assert image.shape[:2] == (scale * nnf.shape[0], scale * nnf.shape[1])
    transparent = (nnf[:, :, 0] < 0).any()
    channels = np.atleast_3d(style).shape[2]
    assert np.atleast_3d(image).shape[2] == channels + transparent * (channels % 2)
    assert image.dtype == style.dtype
    if (nnf >= 0).all():
        assert image.min() >= style.min()
        assert image.max() <= style.max()


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("hostile")


def damaged(draw, content):
    """The bytes with some changed, cut off, or of something else in between."""
    content = bytearray(content)
    for _ in range(draw(st.integers(1, 4))):
        place = draw(st.integers(0, len(content)))
        kind = draw(st.sampled_from(["change", "cut", "insert"]))
        if kind == "change":
            content[place : place + 1] = draw(st.binary(min_size=1, max_size=1))
        elif kind == "cut":
            del content[place:]
        else:
            content[place:place] = draw(st.binary(max_size=20))
    return bytes(content)


def npy_bytes(array):
    file = io.BytesIO()
    np.save(file, array)
    return file.getvalue()


NNF_FILE = npy_bytes(np.full((4, 5, 2), 3, np.int32))


@st.composite
def npy_files(draw):
    if draw(st.booleans()):
        return damaged(draw, NNF_FILE)
    header = draw(st.sampled_from([
        "{'descr': '<i4', 'fortran_order': False, 'shape': (1000000, 1000000, 2), }",
        "{'descr': '<i4', 'fortran_order': False, 'shape': (-1, 4, 2), }",
        "{'descr': '|O', 'fortran_order': False, 'shape': (4, 5, 2), }",
        "{'descr': [('a', '<i4')], 'fortran_order': False, 'shape': (4, 5, 2), }",
        "{'descr': '<i4', 'fortran_order': 2, 'shape': (4, 5, 2), }",
        "__import__('os').getcwd()",
        "(" * 300,
        "{" * 9000,
        "",
    ]))  # fmt: skip
    data = bytes(draw(st.integers(0, 400)))
    text = header.encode() + b"\n"
    return b"\x93NUMPY\x01\x00" + len(text).to_bytes(2, "little") + text + data


@pytest.mark.slow
@generated(250, content=npy_files())
def test_a_damaged_field_is_replayed_or_refused(folder, content):
    (folder / "nnf.npy").write_bytes(content)
    write_image(folder / "style.png", np.full((9, 9, 3), 50, np.uint8))
    command = ["replay", "--nnf", f"{folder / 'nnf.npy'}", "--style", f"{folder / 'style.png'}"]
    (folder / "out.png").unlink(missing_ok=True)
    said = io.StringIO()
    with redirect_stderr(said):
        code = main([*command, "--output", f"{folder / 'out.png'}"])
    assert (folder / "out.png").exists() == (code == 0)
    if code:
        assert code == 2
        *notes, sentence = said.getvalue().splitlines()
        assert sentence.startswith("stylit-ref: ")
        assert all(note.startswith("note: Reading `.npy`") for note in notes)


# Files


@pytest.mark.slow
@generated(
    250,
    image=st.one_of(
        IMAGES,
        st.tuples(
            st.sampled_from(["uint8", "uint16", "float32"]), st.integers(1, 9), st.integers(1, 9),
            st.integers(1, 4), st.integers(0, 9),
        ),
    ),
    suffix=st.sampled_from(
        ["png", "tif", "exr", "jpg", "bmp", "ppm", "tga", "hdr", "webp", "gif", "null", "x", ""]
    ),
)  # fmt: skip
def test_what_is_written_comes_back(folder, image, suffix):
    if isinstance(image, tuple):
        dtype, *shape, seed = image
        image = np.random.default_rng(seed).integers(0, 256, shape).astype(dtype)
    file = folder / f"image.{suffix}"
    file.unlink(missing_ok=True)
    _, sentence = refusal(write_image, file, image)
    assert file.exists() == (sentence is None)
    assert not [other for other in folder.iterdir() if other.name.startswith(".")]
    if sentence:
        assert "image." in sentence
        return
    again = read_image(file)
    assert again.shape[:2] == image.shape[:2]
    kept = {"png": ("uint8", "uint16"), "tif": ("uint8", "uint16", "float32"), "exr": ("float32",)}
    channels = np.atleast_3d(image).shape[2]
    if channels in (1, 3) and str(image.dtype) in kept.get(suffix, ()):
        expected = np.atleast_3d(image)
        if (suffix, str(image.dtype)) != ("tif", "float32"):  # 8-bit display values
            np.testing.assert_array_equal(again, expected)


FILES = {}


@pytest.fixture(scope="module")
def whole_files(folder):
    pixels = np.random.default_rng(0).integers(0, 256, (6, 7, 3), dtype=np.uint8)
    for suffix in ("png", "tif", "exr", "jpg"):
        write_image(folder / f"whole.{suffix}", pixels)
        FILES[suffix] = (folder / f"whole.{suffix}").read_bytes()


@pytest.mark.slow
@generated(400, data=st.data(), suffix=st.sampled_from(["png", "tif", "exr", "jpg"]))
def test_a_damaged_image_is_read_or_refused(whole_files, folder, data, suffix):
    file = folder / f"damaged.{suffix}"
    file.write_bytes(damaged(data.draw, FILES[suffix]))
    image, sentence = refusal(read_image, file)
    if sentence:
        assert "damaged" in sentence
    else:
        assert image.ndim == 3
        assert image.dtype in (np.uint8, np.uint16, np.float32)


@pytest.mark.slow
@generated(
    250,
    name=st.one_of(
        st.text(max_size=20),
        st.text(st.characters(codec=None), max_size=6),
        st.integers(1, 5000).map("x".__mul__),
        st.sampled_from(["..", ".", "~", "a:b", ":", "a.exr:", "-", "\n.png", "\udcff.png"]),
    ),
)
def test_a_path_is_checked_and_refused_in_one_sentence(folder, name):
    for ending in ("", ".png", ".exr:LDE"):
        path = f"{folder}/none/{name}{ending}"
        refusal(check_writable, path)  # a folder that is missing would be made
        assert not (folder / "none").exists()
        _, sentence = refusal(read_image, path)
        assert sentence


# Stores


@pytest.mark.slow
@generated(
    150,
    data=st.data(),
    content=st.sampled_from(["npz", "npy", "other"]),
)
def test_a_damaged_result_is_read_or_none(folder, data, content):
    file = io.BytesIO()
    facts = {"key": "k", "seconds": 1, "stages": {}, "made": "", "history": [{"delta": 1}]}
    arrays = dict.fromkeys(("image", "nnf", "omega", "guide_map", "level_1"), np.zeros((3, 3)))
    if content == "npz":
        np.savez_compressed(file, facts=json.dumps(facts), **arrays)
    elif content == "npy":
        np.save(file, np.zeros(3))
    else:
        np.savez(file, facts=json.dumps(data.draw(JSON)), **arrays)
    result = read(io.BytesIO(damaged(data.draw, file.getvalue())))
    assert result is None or result.key == "k"


JSON = st.recursive(
    st.one_of(st.none(), st.booleans(), st.integers(-9, 9), st.text(max_size=5)),
    lambda inner: st.one_of(
        st.lists(inner, max_size=3),
        st.dictionaries(st.sampled_from(["a", "..", "/etc/x", "a/../../b", "pieces"]), inner),
    ),
    max_leaves=6,
)


@pytest.mark.slow
@generated(200, recipe=JSON, pieces=JSON)
def test_a_foreign_manifest_names_nothing_outside_its_folder(folder, recipe, pieces):
    (folder / "manifest.json").write_text(json.dumps({"recipe": recipe, "pieces": pieces}))
    try:
        manifest = Manifest.read(folder)
    except DataError:
        return
    for files in manifest.pieces.values():
        for file in files:
            assert (folder / file).resolve().is_relative_to(folder.resolve())


# Formulae, against exact arithmetic


@generated(
    200,
    guide_sizes=st.lists(st.integers(1, 5), min_size=1, max_size=4),
    style_channels=st.integers(1, 4),
    influence=st.floats(0, 1000),
    weights=st.lists(st.floats(0, 100), min_size=4, max_size=4),
)
def test_weights_are_the_nearest_in_fixed_point(guide_sizes, style_channels, influence, weights):
    weights = weights[: len(guide_sizes)]
    packing, sentence = refusal(make_packing, guide_sizes, style_channels, influence, weights)
    exact = [ONE * Fraction(influence) / sum(guide_sizes) * Fraction(w) for w in weights]
    if sentence:
        assert any(0 < value < Fraction(501, 1000) or value > 2**32 - 2 for value in exact)
        return
    taken = set()
    style = range(packing.style_channel, packing.style_channel + style_channels)
    for first, size, value in zip(packing.guide_channels, guide_sizes, exact, strict=True):
        for channel in range(first, first + size):
            assert abs(int(packing.weights[channel]) - value) <= Fraction(1, 2) + value / 2**50
            taken.add(channel)
    assert len(taken) == sum(guide_sizes)
    assert not taken & set(style)
    assert (packing.weights[list(style)] == round(ONE / style_channels)).all()
    pairs = packing.weights.reshape(-1, 2)
    assert ((pairs[:, 0] == pairs[:, 1]) | (pairs.min(axis=1) == 0)).all()


@generated(
    200,
    uniformity=st.floats(0, 1e9),
    width=st.sampled_from([3, 5, 7]),
    source=st.integers(9, 10**7),
    target=st.integers(1, 10**7),
)
def test_the_weight_of_w_is_the_nearest_in_fixed_point(uniformity, width, source, target):
    exact = ONE * Fraction(uniformity) * source / (width**4 * target)
    found = occurrence_weight(uniformity, width, source, target)
    assert abs(found - exact) <= Fraction(1, 2) + exact / 2**48


@generated(200, word=st.integers(0, 2**32 - 1), n=st.integers(1, 2**31))
def test_random_numbers_are_below_their_bound(word, n):
    assert uniform_below(np.uint32(word), n) == math.floor(Fraction(word, 2**32) * n)


@generated(100, total=st.integers(0, 255 * 625), count=st.integers(1, 625))
def test_means_are_rounded_half_up(total, count):
    assert rounded_mean(total, count) == math.floor(Fraction(total, count) + Fraction(1, 2))


@generated(
    150,
    patch=hnp.arrays(np.uint8, (3, 3, 2), elements=st.integers(0, 40)),
    weights=st.tuples(st.integers(0, 3), st.integers(0, 3)),
    epsilon=st.one_of(st.floats(0, 1e12), st.sampled_from([0, 2 / 9, 50 / 81, 100])),
)
def test_white_on_the_map_is_a_variance_below_epsilon(patch, weights, epsilon):
    sums = np.array([patch_sum(patch, 0, 0, c, 3) for c in range(2)], np.uint16)
    scaled = scaled_variance(patch, sums, np.array(weights, np.int64), 0, 0, 3)
    variance = Fraction(0)
    for c in range(2):
        values = [Fraction(int(value)) for value in patch[:, :, c].flat]
        if weights[c]:
            variance += sum((value - sum(values) / 9) ** 2 for value in values) / 9
    assert (scaled < variance_limit(epsilon, 3)) == (variance < Fraction(epsilon))
