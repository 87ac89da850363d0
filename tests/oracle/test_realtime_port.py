"""A port of the real-time method from its text alone passes; mistakes are found in stages."""

from pathlib import Path

import naive_realtime
import pytest
from mistakes import assert_found, first_failure

from oracle.families import REALTIME
from oracle.ports import ModulePort

NAIVE = Path(naive_realtime.__file__).parent
VERSION = REALTIME.versions[-1]


@pytest.mark.slow
def test_a_port_written_from_the_text_alone_gives_the_same():
    assert not any("stylit_ref" in file.read_text(encoding="utf-8") for file in NAIVE.glob("*.py"))
    assert first_failure(ModulePort("naive_realtime"), VERSION) is None


MISTAKES = {
    "masks cut above 128": ("light[2] >= 128", "light[2] > 128", "pack_stage"),
    "a shadow on the foreground": (
        "    if identity[0] >= 128:\n        return 2\n    return 1 if is_shadow(light) else 0",
        "    if is_shadow(light):\n        return 1\n    return 2 if identity[0] >= 128 else 0",
        "pack_stage",
    ),
    "a highlight that is in shadow": (
        "    if light[0] >= 128:\n        return 255\n    return 0 if is_shadow(light) else 128",
        "    if is_shadow(light):\n        return 0\n    return 255 if light[0] >= 128 else 128",
        "pack_stage",
    ),
    "colours of identities in another order": (
        "[(0, 255, 0), (0, 0, 255), (255, 0, 0)]",
        "[(255, 0, 0), (0, 255, 0), (0, 0, 255)]",
        "pack_all",
    ),
    "components that wrap around": (
        "np.clip(values, 0, 255)",
        "values % 256",
        "pack_principal",
    ),
    "colours counted from 0": ("1 + colours.index", "colours.index", "pack_principal"),
    "means of four cut off": ("(sum(four) + 2) >> 2", "sum(four) >> 2", "halve"),
    "a last odd row left out": (
        "((side + 1) // 2 for side in image",
        "(max(side // 2, 1) for side in image",
        "halve",
    ),
    "labels of the whole source": (
        "source[top : bottom + 1, left : right + 1]",
        "source",
        "entry_labels",
    ),
    "labels of a level from the middle of a pixel": (
        "labels[:: 1 << level, :: 1 << level]",
        "labels[(1 << level) // 2 :: 1 << level, (1 << level) // 2 :: 1 << level]",
        "entry_labels",
    ),
    "a word for each coordinate": (
        "(word % 65536) * (right",
        "(word >> 16) * (right",
        "random_nnf",
    ),
    "entries counted by columns": (
        "a * grid[1] + b, 0)[0]",
        "b * grid[0] + a, 0)[0]",
        "random_nnf",
    ),
    "the last centre left out": ("(bottom - top + 1)", "(bottom - top)", "random_nnf"),
    "another middle of a small source": (
        "min(radius, (side - 1) // 2)",
        "min(radius, side // 2)",
        "random_nnf",
    ),
    "a small source without a middle": (
        "max(side - 1 - radius, (side - 1) // 2)",
        "max(side - 1 - radius, 0)",
        "search",
    ),
    "means over channels that count": (
        "max(sum(omega), 1)",
        "max(len(omega), 1)",
        "weights",
    ),
    "no common divisor": ("gcd(*guides, style) or 1", "1", "weights"),
    "means of boxes cut off": ("(total + number // 2) // number", "total // number", "records"),
    "boxes of 1, 3, 5": ("(3**scale - 1) // 2", "scale", "records"),
    "scales of the entry, not of its pixel": (
        "samples.at(y * spacing, x * spacing)",
        "samples.at(y, x)",
        "records",
    ),
    "a picture that weighs nothing": ("self.style * colours.sum()", "0", "energy"),
    "a patch of the target that ends at its edge": (
        "found = [clamped(self.image, y + v, x + u) for v in span for u in span]",
        "found = [self.image[(y + v) % self.image.shape[0], (x + u) % self.image.shape[1]]\n"
        "                         for v in span for u in span]",
        "energy",
    ),
    "the other half": ('self.p["half"]) % 2:', 'self.p["half"] + 1) % 2:', "search"),
    "neighbours to the left first": (
        "NEIGHBOURS = (-1, 0), (1, 0), (0, -1), (0, 1)",
        "NEIGHBOURS = (0, -1), (0, 1), (-1, 0), (1, 0)",
        "search",
    ),
    "matches that do not move": (
        "y - v * spacing, x - u * spacing",
        "y, x",
        "search",
    ),
    "neighbours a pixel away": (
        "y - v * spacing, x - u * spacing",
        "y - v, x - u",
        "search",
    ),
    "equal candidates are taken": ("if found < self.best", "if found <= self.best", "search"),
    "random search around the first match": (
        "p, middle, trial = self.p, self.match, 0",
        "p, middle, trial = self.p, tuple(self.nnf[entry].tolist()), 0",
        "search",
    ),
    "a word for every four trials": ("words[trial % 4]", "words[0]", "search"),
    "one draw for all trials": ("position, trial // 4", "position, 0", "search"),
    "a window that moves": (
        "zip(middle, self.bounds, strict=True)",
        "zip(self.match, self.bounds, strict=True)",
        "search",
    ),
    "halves with equal random numbers": ('p["half"], position', "0, position", "search"),
    "a wrong label that may stay": ("WORST if barred else", "", "search"),
    "an entry whose label is lost": (
        "return wanted != FREE and",
        "return",
        "search",
    ),
    "one patch that covers a pixel, not two": (
        "return found if len(found) == 2 else found * 2",
        "return [found[0]] * 2",
        "blend",
    ),
    "four patches cut off": ("total = 2\n", "total = 0\n", "blend"),
    "patches that cover less": (
        "spacing - place <= radius",
        "spacing - place < radius",
        "blend",
    ),
    "a match doubled without its way": (
        "2 * y + spacing * (a - 2 * p), 2 * x + spacing * (b - 2 * q)",
        "2 * y, 2 * x",
        "upsample_nnf",
    ),
    "pixels of the left and above": (
        "p + 1 if y % 2 else p - 1",
        "p - 1",
        "upsample_picture",
    ),
    "bilinear without rounding": ("(total + 8) >> 4", "total >> 4", "upsample_picture"),
    "mu of the coarsest first": (
        '"mu": at(p["mu"], level)',
        '"mu": at(p["mu"], p["levels"] - 1 - level)',
        "frame",
    ),
    "a little style counts as none": (
        'reads_style = at(self.p["mu"], level) > 0',
        'reads_style = at(self.p["mu"], level) > 1',
        "frame",
    ),
    "a picture blended once": ("if iteration > 0 and reads_style:", "if False:", "frame"),
    "radii of the finest level": ('at(p["radii"], level)', 'at(p["radii"], 0)', "frame"),
    "half of the shorter side": (
        "min(max(height, width) // 2",
        "min(min(height, width) // 2",
        "frame",
    ),
    "labels of the finest level": ("picked(side, level) for", "picked(side, 0) for", "frame"),
    "iterations counted on": ('"iteration": iteration', '"iteration": iteration + 1', "frame"),
    "a vote where there should be none": ('self.p["start"] == "vote" or', "True or", "frame"),
    "a warm frame that begins at random": (
        'frame.refine(a["nnf"], None, 0, settles=True)',
        'a["nnf"] = frame.begin(None, p["levels"] - 1) if p["levels"] == 1 else frame.cold()',
        "warm_frame",
    ),
    "a match that is old when it differs 4 times as much": (
        "energy.of(parent, own) > 4 *",
        "energy.of(parent, own) >= 4 *",
        "renew",
    ),
    "a renewal that reads what it has renewed": (
        "before[first].tolist()",
        "nnf[first].tolist()",
        "renew",
    ),
    "a renewal that heeds no labels": (
        "        if not barred(entry, match):\n            nnf[entry] = match",
        "        nnf[entry] = match",
        "renew",
    ),
    "wrong labels that stay": (
        "if not old and not barred(entry, tuple(before[entry])):",
        "if not old:",
        "renew",
    ),
    "a block that takes one match": (
        "(at << k) + spacing * (place - start)",
        "at << k",
        "renew",
    ),
    "a warm frame that renews nothing": (
        'if level > 0 and at(p["mu"], level) < 16:',
        "if False:",
        "warm_frame",
    ),
    "a warm frame with the style's weight of a cold one": (
        'mu if p["scale_space"] else [p["warm_mu"], *mu[1:]]',
        "mu",
        "warm_frame",
    ),
    "a warm frame with the radius of a cold one": (
        '[p["warm_radius"], *radii[1:]]',
        "radii",
        "warm_frame",
    ),
    "a warm frame with the iterations of a cold one": (
        '[p["warm_iterations"], *',
        "[iterations[0], *",
        "warm_frame",
    ),
    "a warm frame that searches everything again": ("if settles:", "if False:", "warm_frame"),
    "entries beside those that moved stay": (
        "moving[max(a - 1, 0) : a + 2, max(b - 1, 0) : b + 2] = True",
        "moving[a, b] = True",
        "warm_frame",
    ),
    "entries that moved once move on": (
        "moving = moving_entries(before, nnf)",
        "moving = moving_entries(before, nnf) | (False if moving is None else moving)",
        "warm_frame",
    ),
    "a warm frame with all iterations": ("(count + 1) // 2", "count", "warm_frame"),
    "a warm frame with iterations rounded down": ("(count + 1) // 2", "count // 2", "warm_frame"),
    "a finish that keeps the first match": ("if found < best:", "if False:", "dense_nnf"),
    "equal matches of a finish are taken": (
        "                if found < best:",
        "                if found <= best:",
        "dense_nnf",
    ),
    "a finish that heeds no labels": (
        "if other != match and not is_barred(other)",
        "if True",
        "dense_nnf",
    ),
    "a wrong first match that keeps its energy": (
        "best = WORST if is_barred(match) else",
        "best =",
        "dense_nnf",
    ),
    "matches that stay where the entry's is": (
        "(down + y - a * spacing, right + x - b * spacing), bounds",
        "(down, right), bounds",
        "dense_nnf",
    ),
    "a vote cut off": (
        "(total + number // 2) // number\n    return picture",
        "total // number\n    return picture",
        "vote",
    ),
    "a vote that reads beyond the picture": (
        "range(max(y - radius, 0), min(y + radius, height - 1) + 1)",
        "range(max(y - radius + 1, 0), min(y + radius, height - 1) + 1)",
        "vote",
    ),
    "a finish without a blend": (
        '"target_style": picture}',
        '"target_style": 0 * picture}',
        "finish",
    ),
    "a replay with the old style": (
        '"replayed": after.blended(nnf, 0)',
        '"replayed": Frame(p, a).blended(nnf, 0)',
        "stroke",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_found_at_its_stage(mistake, tmp_path, monkeypatch):
    name = f"mistaken_realtime_{list(MISTAKES).index(mistake)}"
    assert_found(NAIVE, name, MISTAKES[mistake], VERSION, tmp_path, monkeypatch)
