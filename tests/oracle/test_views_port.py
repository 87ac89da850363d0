"""A port of coherent frames from their text alone passes; mistakes are found in stages."""

from pathlib import Path

import naive_views
import pytest
from mistakes import assert_found, first_failure

from oracle.families import VIEWS
from oracle.ports import ModulePort

NAIVE = Path(naive_views.__file__).parent
VERSION = VIEWS.versions[-1]


@pytest.mark.slow
def test_a_port_written_from_the_text_alone_gives_the_same():
    assert not any("stylit_ref" in file.read_text(encoding="utf-8") for file in NAIVE.glob("*.py"))
    assert first_failure(ModulePort("naive_views"), VERSION) is None


MISTAKES = {
    "x and y in each other's place": (
        "dx, dy = motion.field[from_pixel]",
        "dy, dx = motion.field[from_pixel]",
        "shift_map",
    ),
    "round half to even": (
        "return floor(place + Fraction(float(component)) / 2**depth + Fraction(1, 2))",
        "return round(place + Fraction(float(component)) / 2**depth)",
        "shift_map",
    ),
    "rounding in floats": (
        "return floor(place + Fraction(float(component)) / 2**depth + Fraction(1, 2))",
        "return floor(np.float32(place) + np.float32(component) / 2**depth + np.float32(0.5))",
        "shift_map",
    ),
    "vectors in pixels of the level": (
        "Fraction(float(component)) / 2**depth",
        "Fraction(float(component))",
        "shift_map",
    ),
    "motion of the first pixel that a coarser one covers": (
        "step, half = 2**depth, 2**depth // 2",
        "step, half = 2**depth, 0",
        "shift_map",
    ),
    "vectors compared with the sides of the level": (
        "isfinite(dx) and isfinite(dy)",
        "abs(dx) <= width // step and abs(dy) <= height // step",
        "shift_map",
    ),
    "hidden pixels that are shifted": ("motion.visible[from_pixel] and ", "", "shift_map"),
    "black where the neighbour shows nothing": (
        "guide = own.copy()",
        "guide = 0 * own",
        "shift_picture",
    ),
    "vectors compared as they are": (
        "f, b = fixed_vector(forth), fixed_vector(back)",
        "f, b = ([256 * float(v) for v in vector] for vector in (forth, back))",
        "cancel",
    ),
    "half of a pixel, not of its square": ("away - 32768", "away - 16384", "cancel"),
    "sums of 64 bits that wrap around": (
        "abs(component) > 2**18:\n        return 2**26 if component > 0 else -(2**26)",
        "abs(component) > 2**20:\n        return 0",
        "cancel",
    ),
    "the motion back is always known": (
        "place != NOWHERE and back.visible[place]",
        "place != NOWHERE",
        "cancel",
    ),
    "the second motion at the same pixel": (
        "first.field[pixel] + second.field[place]",
        "first.field[pixel] + second.field[pixel]",
        "compose",
    ),
    "of equals the last lands": (
        "self.distance(pixel, place) < self.distance(before, place)",
        "self.distance(pixel, place) <= self.distance(before, place)",
        "splat",
    ),
    "of equals the first lands, however far": (
        "return self.distance(pixel, place) < self.distance(before, place)",
        "return False",
        "splat",
    ),
    "the farthest wins": (
        "return self.depth[pixel] < self.depth[before]",
        "return self.depth[pixel] > self.depth[before]",
        "splat",
    ),
    "nothing is nearest": (
        "if 0 < depth[pixel] < 1e9:",
        "if depth[pixel] < 1e9:",
        "splat",
    ),
    "vectors that differ by a pixel": (
        "abs(ours[0] - theirs[0]) > 256 or",
        "abs(ours[0] - theirs[0]) >= 256 or",
        "splat",
    ),
    "vectors that are not turned": (
        "= -motion.field[tuple(landing",
        "= motion.field[tuple(landing",
        "invert",
    ),
    "contested places that are shown": (
        "    if depth is None:\n        visible &= ~landing.contested\n",
        "",
        "invert",
    ),
    "cracks that stay open": ("and close(before[one], before[two])", "and False", "invert"),
    "cracks filled one after the other": (
        "before, seen = field.copy(), visible.copy()",
        "before, seen = field, visible",
        "invert",
    ),
    "cracks along columns first": (
        "empty, 0, 1)\n    fill_cracks(field, visible, empty, 1, 0)",
        "empty, 1, 0)\n    fill_cracks(field, visible, empty, 0, 1)",
        "invert",
    ),
    "cracks that show something else": ("visible & ~certain", "visible & False", "invert"),
    "without depth the beaten alone are hidden": (
        "landing.contested[place] if depth is None else landing.beaten[pixel]",
        "landing.beaten[pixel]",
        "unhidden",
    ),
    "steps of depth, not of its inverse": (
        "return 1 / depth_of_things(depth)",
        "return -depth_of_things(depth)",
        "rims",
    ),
    "a floor that recedes is a step": (
        "is_nearer(near, far) and near - far > 2 * slope",
        "is_nearer(near, far)",
        "rims",
    ),
    "a value nearer by just a twentieth": (
        "value > 1.05 * other",
        "value >= 1.049 * other",
        "rims",
    ),
    "something is very far away": (
        "if 0 < depth[pixel] < 1e9:",
        "if 0 < depth[pixel] < np.inf:",
        "rims",
    ),
    "rims within a square": (
        "distance = (rim[0] - y) ** 2 + (rim[1] - x) ** 2",
        "distance = max(abs(rim[0] - y), abs(rim[1] - x)) ** 2",
        "beside",
    ),
    "the nearest rim, not the closest": (
        "found.append((distance, -inverse[rim], rim))",
        "found.append((-inverse[rim], distance, rim))",
        "beside",
    ),
    "the first of rims as close": (
        "found.append((distance, -inverse[rim], rim))",
        "found.append((distance, rim, rim))",
        "beside",
    ),
    "the rim itself, not what is past it": (
        "or is_nearer(inverse[rim], inverse[beyond])",
        "or True",
        "beside",
    ),
    "past a thing of one pixel": (
        " or is_nearer(inverse[rim], inverse[beyond])",
        "",
        "beside",
    ),
    "past the end of the frame": (
        "    if not is_inside(beyond, inverse.shape) or is_nearer",
        "    beyond = beyond[0] % inverse.shape[0], beyond[1] % inverse.shape[1]\n    if is_nearer",
        "beside",
    ),
    "strokes that always reach a pixel": (
        "max(1, (8 * max(size) + 300) // 600)",
        "1",
        "along",
    ),
    "strokes that find something else": (
        "if place != NOWHERE:\n            mine, other",
        "if False:\n            mine, other",
        "along",
    ),
    "visibility of the pixel itself": (
        "field[pixel], visible[pixel] = motion.field[mine], motion.visible[mine]",
        "field[pixel], visible[pixel] = motion.field[mine], motion.visible[pixel]",
        "along",
    ),
    "what the file tells is not heeded": ("elif files.tells_visible:", "elif False:", "motion"),
    "one visibility for both directions": (
        'self.known(f"{way}_shown", frame)',
        'self.a.get(f"forward_shown_{frame}", self.known(f"{way}_shown", frame))',
        "motion",
    ),
    "depth of the wrong frame": (
        'inverted(back, files.known("depth", neighbour))',
        'inverted(back, files.known("depth", frame))',
        "motion",
    ),
    "labels that are not compared": (
        "motion.visible & same_labels(motion, *labels)",
        "motion.visible",
        "motion",
    ),
    "silhouettes of one end": (
        "None if any(each is None for each in found) else found",
        "next(([each] * 2 for each in found if each is not None), None)",
        "motion",
    ),
    "labels beside the depth of one frame": (
        "if labels is not None:\n        return along",
        'if labels is not None and files.known("depth", to) is None:\n        return along',
        "motion",
    ),
    "means cut off": (
        "(2 * total + everything) // (2 * everything)",
        "total // everything",
        "fold",
    ),
    "a spread that is cut off": ("floor(sqrt(variance) + 0.5)", "floor(sqrt(variance))", "fold"),
    "a spread of the mean channel": (
        "float(everything**2)",
        "float(own.shape[2] * everything**2)",
        "fold",
    ),
    "weights of the style cut off": (
        "(style * factor + 128) // 256",
        "style * factor // 256",
        "weights",
    ),
    "a spread that weighs as much as the style": ("style[:1] if", "[style.sum()] if", "weights"),
    "a weight rounded down": (
        "floor(float(weight) * 256 + 0.5)",
        "floor(float(weight) * 256)",
        "weights",
    ),
    "sweeps that always rise": ('order == "sweeps" and k > 0 and k % 2 == 0', "False", "plan"),
    "the first states in a falling sweep": ("and k > 0 and k % 2 == 0", "and k % 2 == 0", "plan"),
    "votes that are the same in frames that follow": (
        "following_votes if follows else votes",
        "votes",
        "plan",
    ),
    "frames that follow though nothing pulls": ("len(neighbours[frame]) > 0", "frame > 0", "plan"),
    "the last state of a neighbour by one's own votes": (
        "frame_votes[other][-1]",
        "frame_votes[task[0]][-1]",
        "plan",
    ),
    "sweeps that see the iteration before": ("k if is_ahead else k - 1", "k - 1", "plan"),
    "a spread that StyLit does not see": (
        'with_spread = p["method"] == "stylit" and len(shifts) > 0',
        "with_spread = False",
        "iteration",
    ),
    "a spread in the source": (
        "nothing = np.zeros((*style.shape[:2], 1), np.int64)",
        "nothing = np.full((*style.shape[:2], 1), 9)",
        "iteration",
    ),
    "places of the finest level": (
        "places_of(motion, self.levels - level)",
        "places_of(motion, 0)[: picture.shape[0], : picture.shape[1]].clip(-1, 2)",
        "iteration",
    ),
    "a picture that is not folded": (
        "target = np.concatenate([guides, mixed], axis=-1)",
        "target = np.concatenate([guides, picture], axis=-1)",
        "iteration",
    ),
    "outliers that count": (
        'nnf, self.radius, self.p["outliers"])',
        "nnf, self.radius)",
        "iteration",
    ),
    "votes counted from 0": (
        "nnf = self.search(source, target, weights, nnf, level, k)",
        "nnf = self.search(source, target, weights, nnf, level, k - 1)",
        "iteration",
    ),
    "frames that see only those before them": (
        'p["order"] != "sequential" or other < to',
        "other < to",
        "run",
    ),
    "a level that begins anew": (
        "if level == 1:\n            return random_nnf",
        "if True:\n            return random_nnf",
        "run",
    ),
    "another seed for each frame": (
        'int(self.p["seed"]), level)\n        return upsample_nnf',
        'int(self.p["seed"]) + size[0], level)\n        return upsample_nnf',
        "run",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_found_at_its_stage(mistake, tmp_path, monkeypatch):
    name = f"mistaken_views_{list(MISTAKES).index(mistake)}"
    assert_found(NAIVE, name, MISTAKES[mistake], VERSION, tmp_path, monkeypatch)
