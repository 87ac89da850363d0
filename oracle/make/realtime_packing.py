"""The cases of packing."""

from collections.abc import Iterator

import numpy as np

from oracle.make.realtime_scene import noise
from stylit_ref.realtime.packing import PrincipalPacking
from stylit_ref.realtime.packing.stage import COLOURED, STAGE_BUFFERS


def packings(rng: np.random.Generator) -> Iterator[tuple[str, str, dict, dict]]:
    """Stage, name, parameters and arrays of every case."""
    for name, size, flat in (("plain", (6, 7), 3), ("grey", (5, 4), 1), ("one_pixel", (1, 1), 3)):
        buffers = _stage(rng, size, flat)
        yield "pack_stage", name, {}, buffers
        yield "pack_all", name, {}, buffers
    buffers = _stage(rng, (4, 5), 1)
    grey = {name: plane[:, :, 0] for name, plane in buffers.items() if name not in COLOURED}
    yield "pack_stage", "flat", {}, buffers | grey
    buffers = _stage(rng, (8, 8), 3)
    for name in COLOURED:
        buffers[name] = rng.choice(np.array([127, 128], np.uint8), (8, 8, 3))
    yield "pack_stage", "at_128", {}, buffers
    yield "pack_all", "at_128", {}, buffers
    for name, size, channels in (
        ("plain", (9, 8), (3, 3, 1)),
        ("two_buffers", (6, 7), (1, 3)),
        ("many", (9, 10), (3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 1, 1)),
        ("clipped", (7, 8), (3, 3)),
        ("unknown_colours", (6, 6), (3,)),
        ("one_pixel", (1, 1), (3, 1)),
    ):
        source = _scene(rng, (12, 13), channels)
        packing = PrincipalPacking.of_source(source)
        target = _scene(rng, size, channels)
        if name == "clipped":
            target = {key: np.where(plane < 128, 0, 255) for key, plane in target.items()}
            target = {key: plane.astype(np.uint8) for key, plane in target.items()}
            target["IDMASK"] = source["IDMASK"][:7, :8]
        if name == "unknown_colours":
            target["IDMASK"][::2] += 3
        made = {
            "axes": packing.axes, "offsets": packing.offsets, "colours": packing.colours,
        }  # fmt: skip
        yield "pack_principal", name, {}, target | made


def _stage(rng, size, channels):
    buffers = {name: noise(rng, size, channels) for name in STAGE_BUFFERS}
    for name in COLOURED:
        buffers[name] = rng.integers(0, 256, (*size, 3), dtype=np.uint8)
    return buffers


def _scene(rng, size, channels):
    """Buffers that vary together, so that a few components hold most."""
    common = noise(rng, size, 1).astype(np.int64)
    buffers = {
        f"buffer_{k}": ((common * k + noise(rng, size, count)) // (k + 1)).astype(np.uint8)
        for k, count in enumerate(channels, 1)
    }
    colours = np.array([[255, 0, 0], [0, 0, 255], [0, 255, 0], [1, 2, 3]], np.uint8)
    buffers["IDMASK"] = colours[rng.integers(0, 4, size)]
    return buffers
