"""A port of texture synthesis written from its text alone passes; mistakes are found in stages."""

from pathlib import Path

import naive_texture
import pytest
from mistakes import assert_found, first_failure

from oracle.families import TEXTURE
from oracle.ports import ModulePort

NAIVE = Path(naive_texture.__file__).parent
VERSION = TEXTURE.versions[-1]


@pytest.mark.slow
def test_a_port_written_from_the_text_alone_gives_the_same():
    assert not any("stylit_ref" in file.read_text(encoding="utf-8") for file in NAIVE.glob("*.py"))
    assert first_failure(ModulePort("naive_texture"), VERSION) is None


MISTAKES = {
    "white noise by columns": ("y * width + x, 0)[0]", "x * height + y, 0)[0]", "white_noise"),
    "an iteration counted from 1": (
        "philox(position, number, iteration,",
        "philox(position, number, iteration + 1,",
        "white_noise",
    ),
    "cells at equal distances": (
        "(first + i * side // count) % side",
        "(first + i * (side // count)) % side",
        "grid",
    ),
    "phases in columns": (
        "for v in range(4):\n        for u in range(4):",
        "for u in range(4):\n        for v in range(4):",
        "exemplars",
    ),
    "phases cut off instead of rounded": ("+ b * v + 8) >> 4", "+ b * v) >> 4", "exemplars"),
    "the literal cost of existing seams": (
        "distance(here, before) + distance(there, after)",
        "2 * distance(there, after)",
        "seams",
    ),
    "powers of doubles": (
        "power = np.float32(power * q)",
        "power = power * np.float64(q)",
        "seams",
    ),
    "a quotient of integers": (
        "power = np.float32(1) * q",
        "q = np.float32(np.floor(q * 4096) / 4096)\n    power = q",
        "seams",
    ),
    "costs rounded to the nearest": (
        "return int(min(np.float32(power * np.float32(256)), np.float32(2**24)))",
        "return round(float(min(np.float32(power * np.float32(256)), np.float32(2**24))))",
        "seams",
    ),
    "the high half of a word decides on coherence": (
        "words[1] % 65536 <",
        "words[1] >> 16 <",
        "candidates",
    ),
    "distances of candidates without a limit": (
        "int(shown)), 20000)",
        "int(shown)), 200000)",
        "candidates",
    ),
    "candidates without a price": ("total = price(p, a, chosen)", "total = 0", "candidates"),
    "a price for the whole disc": ('p["radius"] // 2', 'p["radius"]', "candidates"),
    "candidates seen without the guide": ('if p.get("guide_weight"):', "if False:", "candidates"),
    "a lock that is ignored": (
        "return self.anything_locked and bool(",
        "return bool(0) and bool(",
        "costs",
    ),
    "weights of 14 bits": ("(value + 512) >> 10", "(value + 8192) >> 14", "costs"),
    "new edges without a limit": (
        'return min(cost >> self.halved, self.p["new_limit"])',
        "return cost >> self.halved",
        "costs",
    ),
    "a limit before halving": (
        'min(cost >> self.halved, self.p["new_limit"])',
        'min(cost, self.p["new_limit"]) >> self.halved',
        "costs",
    ),
    "what a pixel hides without a limit": (
        "min(limit, hidden[p] >> self.halved)",
        "hidden[p] >> self.halved",
        "costs",
    ),
    "a limit of what is hidden, not of what is paid": (
        "max(-limit, min(limit, hidden[p] >> self.halved))",
        "min(limit, hidden[p] >> self.halved)",
        "costs",
    ),
    "seams halved one by one": (
        "total = sum(costs)",
        'total = sum(min(cost, self.p["existing_limit"]) for cost in costs)',
        "costs",
    ),
    "halved by a sum in place of absolute values": (
        "sum(abs(cost) for cost in hidden.values())",
        "sum(hidden.values())",
        "costs",
    ),
    "halved by what the disc hides alone": (
        "widest + 1, radius + 2)",
        "widest, radius + 1)",
        "costs",
    ),
    "a ray that ends a column late": ("max(ended - 1, 0)", "ended", "costs"),
    "products cut off instead of rounded": ("(value + 512) >> 10", "value >> 10", "costs"),
    "ties to the right": (
        "= min(ways)",
        "= min(ways, key=lambda way: (way[0], -way[1]))",
        "cut",
    ),
    "no step that closes the cut": (
        "abs(sums[x] - sums[j])",
        "(abs(sums[x] - sums[j]) if y < rows else 0)",
        "cut",
    ),
    "a cut that need not close": ("if follow(origins, x)[0] == x]", "]", "cut"),
    "a first row that one arrives in for nothing": (
        "min(int(arrivals[x]) + int(crossing[0, x]), BLOCKED)",
        "int(crossing[0, x])",
        "cut",
    ),
    "a turn that pays for the one before": (
        "totals[-1, x] - arrivals[x]",
        "totals[-1, x]",
        "cut",
    ),
    "a second pass like the first": (
        "arrivals = [min(end - min(ends), BLOCKED) for end in ends]",
        "arrivals = [0 for end in ends]",
        "closed_cut",
    ),
    "the smallest cut forgotten": ("if smallest < cost:", "if False:", "closed_cut"),
    "shifts the other way": ("there = (y + k) % rows", "there = (y - k) % rows", "alignment"),
    "the colour on the cut, not inside it": (
        'int(a["border"][path[there] + 1]) - 128',
        'int(a["border"][path[there] + 1])',
        "alignment",
    ),
    "an alignment that is not halved": ("cost >> patch.halved", "cost", "alignment"),
    "an alignment without a limit": (
        'min(cost >> patch.halved, p["new_limit"])',
        "(cost >> patch.halved)",
        "alignment",
    ),
    "locked pixels that an alignment pays for": ("0 if free else r10(", "r10(", "alignment"),
    "quarters of x before those of y": (
        "4 * (qy % 4) + qx % 4",
        "4 * (qx % 4) + qy % 4",
        "alignment",
    ),
    "a raster up to the column before": ("border[path[row] + 1]", "border[path[row]]", "raster"),
    "the row below an angle, not the nearest": ("(angle + 128) >> 8", "angle >> 8", "raster"),
    "deformation that does not fade": ('int(a["powers"][ratio])', "4096", "raster"),
    "a change without guides": ('if p["guide_weight"]:', "if False:", "change"),
    "patches written one after another": (
        "    for (y, x), (_, _, pixels) in zip(cells, judged, strict=True):\n"
        "        if pixels is not None:",
        "    judged = []\n"
        "    for cell, (y, x) in enumerate(cells):\n"
        "        judged.append(fit(p, a, centres, cell, y, x))\n"
        "        count_seams(p, a)\n"
        "        pixels = judged[-1][2]\n"
        "        if pixels is not None:",
        "iteration",
    ),
    "exact patches that the table rejects": (
        'p["predicate"] == "before" and best[0]',
        'p["predicate"] in ("before", "exact") and best[0]',
        "iteration",
    ),
    "a patch given up with its deformation": (
        "outcome == ACCEPTED and cost >= 0:",
        'outcome == ACCEPTED and (cost >= 0 or p["max_shift"] > 0 and bent_change < changed):',
        "iteration",
    ),
    "the last of several cuts": ("or cost << patch.halved < best[0]", "or True", "iteration"),
    "cuts compared as halved": (
        "cost << patch.halved < best[0]",
        "cost << 0 < best[0]",
        "iteration",
    ),
    "a step of the cut that costs nothing": ("stepped + along +", "along +", "iteration"),
    "the inside of a patch not halved": (">> patch.halved) - hides", ") - hides", "iteration"),
    "what is hidden forgotten": ("patch.halved) - hides", "patch.halved)", "iteration"),
    "deformation whether it helps or not": (
        "if bent_change < changed and",
        "if True and",
        "iteration",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_found_at_its_stage(mistake, tmp_path, monkeypatch):
    name = f"mistaken_texture_{list(MISTAKES).index(mistake)}"
    assert_found(NAIVE, name, MISTAKES[mistake], VERSION, tmp_path, monkeypatch)
