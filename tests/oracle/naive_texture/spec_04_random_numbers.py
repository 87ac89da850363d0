"""4. Random numbers."""

import numpy as np

WORD = 0xFFFFFFFF
WHITE_NOISE, GRID, PATCHES = 16, 17, 18


def philox(c0, c1, c2, c3, k0, k1):
    """Compute Philox4x32-10."""
    for _ in range(10):
        h0, l0 = divmod(0xD2511F53 * c0, 2**32)
        h1, l1 = divmod(0xCD9E8D57 * c2, 2**32)
        c0, c1, c2, c3 = h1 ^ c1 ^ k0, l1, h0 ^ c3 ^ k1, l0
        k0, k1 = (k0 + 0x9E3779B9) & WORD, (k1 + 0xBB67AE85) & WORD
    return c0, c1, c2, c3


def draw(seed, purpose, iteration, position, number):
    """Draw four words."""
    return philox(position, number, iteration, purpose << 16, seed & WORD, seed >> 32)


def below(word, n):
    """Turn a word into an integer below n."""
    return (word * n) >> 32


def white_noise(pixels, height, width, seed):
    """Give S at random."""
    addresses = np.zeros((height, width), int)
    for y, x in np.ndindex(height, width):
        word = draw(seed, WHITE_NOISE, 0, y * width + x, 0)[0]
        addresses[y, x] = pixels[below(word, len(pixels))]
    return addresses


def grid(height, width, radius, seed, iteration):
    """List the cells."""
    words = draw(seed, GRID, iteration, 0, 0)
    axes = []
    for word, side in zip(words, (height, width), strict=False):
        count = max(1, side // (2 * radius))
        first = below(word, side)
        axes.append([(first + i * side // count) % side for i in range(count)])
    return [(y, x) for y in axes[0] for x in axes[1]]


def stage_white_noise(p, a):
    """Do stage white_noise."""
    return {"addresses": white_noise(a["pixels"], p["height"], p["width"], p["seed"])}


def stage_grid(p, a):
    """Do stage grid."""
    sizes = (p[name] for name in ("height", "width", "radius", "seed", "iteration"))
    return {"cells": grid(*sizes)}


STAGES = {"white_noise": stage_white_noise, "grid": stage_grid}
