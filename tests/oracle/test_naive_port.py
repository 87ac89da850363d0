"""A port written from the text alone passes, and each mistake in it is found at its stage."""

from pathlib import Path

import naive_port
import pytest
from mistakes import assert_found, first_failure

from oracle.families import NEWEST
from oracle.ports import ModulePort

NAIVE = Path(naive_port.__file__).parent


@pytest.mark.slow
def test_a_port_written_from_the_text_alone_gives_the_same():
    assert not any("stylit_ref" in file.read_text(encoding="utf-8") for file in NAIVE.glob("*.py"))
    assert first_failure(ModulePort("naive_port"), NEWEST) is None


MISTAKES = {
    "an off-by-one radius": (
        "while 2**k <= max(height, width) // 2:",
        "while 2**k < max(height, width) // 2:",
        "random_search",
    ),
    "a float metric": (
        "total += (weights * difference * difference).sum(axis=-1)",
        "total += (weights * difference * difference).astype(np.float32).sum(axis=-1).astype(int)",
        "delta",
    ),
    "a metric of doubles": (
        "total += (weights * difference * difference).sum(axis=-1)",
        "total = total + (weights * difference * difference).astype(float).sum(axis=-1)",
        "delta",
    ),
    "Ω live instead of committed": (
        """for class_y, class_x in order:
        in_class = (ys % 4 == class_y) & (xs % 4 == class_x) & assigned_pixels(nnf)""",
        """pixels = [(y, x) for c, d in order for y in range(c, len(ys), 4)
              for x in range(d, len(ys[0]), 4)]
    for pixel_y, pixel_x in pixels:
        in_class = (ys == pixel_y) & (xs == pixel_x) & assigned_pixels(nnf)""",
        "commit",
    ),
    "commit classes in another order": (
        "order = [(k // 4, k % 4) for k in range(16)]",
        "order = [(k % 4, k // 4) for k in range(16)]",
        "commit_order",
    ),
    "a swapped candidate order": (
        "((0, distance), (distance, 0), (0, -distance), (-distance, 0))",
        "((distance, 0), (0, distance), (0, -distance), (-distance, 0))",
        "propagation",
    ),
    "round half to even": (
        "(2 * total + n) // np.maximum(2 * n, 1)",
        "np.rint(total / np.maximum(n, 1)).astype(int)",
        "vote",
    ),
    "mirrored instead of clamped": (
        "y = np.clip(pixels[..., 0] + dy, 0, height - 1)",
        "y = np.pad(np.arange(height), 9, mode='symmetric')[pixels[..., 0] + dy + 9]",
        "delta",
    ),
    "an equal candidate replaces": (
        "better = valid & (candidate_phi < self.phi)",
        "better = valid & (candidate_phi <= self.phi)",
        "propagation",
    ),
    "the seed's words swapped": (
        "seed & WORD, (seed >> 32) & WORD",
        "(seed >> 32) & WORD, seed & WORD",
        "random_nnf",
    ),
    "an iteration counted from 0": (
        "for iteration in range(1, iterations + 1):",
        "for iteration in range(iterations):",
        "level",
    ),
    "a later claim wins a tie": (
        "error < delta_values[pixel]:",
        "error <= delta_values[pixel]:",
        "settle",
    ),
    "all claims made anew in a retrieval": (
        "for iteration in range(iterations * k + 1,",
        "claims[:] = 0\n        for iteration in range(iterations * k + 1,",
        "stylit_search",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_found_at_its_stage(mistake, tmp_path, monkeypatch):
    name = f"mistaken_{list(MISTAKES).index(mistake)}"
    assert_found(NAIVE, name, MISTAKES[mistake], NEWEST, tmp_path, monkeypatch)
