"""4. Random numbers."""

import numpy as np

WORD = 0xFFFFFFFF
RANDOM_NNF, RANDOM_SEARCH, COMMIT_ORDER, RANDOM_CLAIMS, CLAIM_SEARCH = 1, 2, 3, 4, 5


def philox(counters, keys):
    """Compute Philox4x32-10 of counters (n, 4) and keys (n, 2)."""
    c0, c1, c2, c3 = (counters[:, i].astype(np.uint64) for i in range(4))
    k0, k1 = (keys[:, i].astype(np.uint64) for i in range(2))
    low, shift = np.uint64(WORD), np.uint64(32)
    for _ in range(10):
        product0 = np.uint64(0xD2511F53) * c0
        product1 = np.uint64(0xCD9E8D57) * c2
        h0, l0 = product0 >> shift, product0 & low
        h1, l1 = product1 >> shift, product1 & low
        c0, c1, c2, c3 = h1 ^ c1 ^ k0, l1, h0 ^ c3 ^ k1, l0
        k0 = (k0 + np.uint64(0x9E3779B9)) & low
        k1 = (k1 + np.uint64(0xBB67AE85)) & low
    return np.stack([c0, c1, c2, c3], axis=1)


def make_stream(purpose, seed, level, vote=0, iteration=0):
    """Name a stream: (c2, c3, k0, k1)."""
    return vote << 16 | iteration, purpose << 16 | level, seed & WORD, (seed >> 32) & WORD


def draw_words(stream, positions, draw):
    """Draw the four words of each position."""
    c2, c3, k0, k1 = stream
    count = len(positions)
    counters = np.empty((count, 4), np.uint64)
    counters[:, 0] = positions
    counters[:, 1] = draw
    counters[:, 2] = c2
    counters[:, 3] = c3
    keys = np.empty((count, 2), np.uint64)
    keys[:, 0] = k0
    keys[:, 1] = k1
    return philox(counters, keys)


def draw_grid(stream, height, width, draw):
    """Draw the four words of each target pixel."""
    return draw_words(stream, np.arange(height * width), draw).reshape(height, width, 4)


def below(words, n):
    """Turn words into integers below n."""
    return ((words * np.asarray(n).astype(np.uint64)) >> np.uint64(32)).astype(np.int64)


def case_stream(purpose, p):
    """Give the stream that the parameters name."""
    return make_stream(purpose, int(p["seed"]), p["level"], p["vote"], p["iteration"])


def stage_philox(p, a):
    """Do stage philox."""
    return {"words": philox(a["counters"], a["keys"])}


STAGES = {"philox": stage_philox}
