"""2. Packing."""

import numpy as np

BUFFERS = "FULL", "LDE", "LDDE", "LSE", "IDMASK", "FRESNEL", "LIGHTMASK"
IDENTITIES = [(0, 255, 0), (0, 0, 255), (255, 0, 0)]


def three(buffer):
    """Give a buffer three channels."""
    buffer = buffer.reshape(*buffer.shape[:2], -1)
    return np.repeat(buffer, 3, axis=2) if buffer.shape[2] == 1 else buffer


def is_shadow(light):
    """Tell whether a colour of LIGHTMASK is that of a shadow."""
    return light[2] >= 128


def label_of(identity, light):
    """Give the label of a pixel of the stage."""
    if identity[0] >= 128:
        return 2
    return 1 if is_shadow(light) else 0


def lit(light):
    """Give the byte of LIGHTMASK."""
    if light[0] >= 128:
        return 255
    return 0 if is_shadow(light) else 128


def stage(arrays, pack):
    """Pack all pixels of a stage."""
    planes = {name: three(arrays[name]) for name in BUFFERS}
    size = planes["FULL"].shape[:2]
    labels, features = np.zeros(size, int), {}
    for pixel in np.ndindex(size):
        at = {name: [int(value) for value in planes[name][pixel]] for name in BUFFERS}
        labels[pixel] = label_of(at["IDMASK"], at["LIGHTMASK"])
        features[pixel] = pack(at, labels[pixel])
    features = np.array(list(features.values())).reshape(*size, -1)
    return {"features": features, "labels": labels}


def ten_bytes(at, label):
    """Pack a pixel as Figure 16."""
    light = [at[name][c] for name in ("FULL", "LDE", "LDDE") for c in (0, 1)]
    identity = (0, 128, 255)[label]
    return [*light, at["LSE"][0], identity, at["FRESNEL"][0], lit(at["LIGHTMASK"])]


def all_bytes(at, label):
    """Keep all of a pixel."""
    at = at | {"IDMASK": IDENTITIES[label]}
    return [value for name in BUFFERS for value in at[name]]


def stage_pack_stage(p, a):
    """Do stage pack_stage."""
    return stage(a, ten_bytes)


def stage_pack_all(p, a):
    """Do stage pack_all."""
    return stage(a, all_bytes)


def stage_pack_principal(p, a):
    """Do stage pack_principal."""
    names = [f"buffer_{k}" for k in range(1, 33) if f"buffer_{k}" in a]
    size = a["IDMASK"].shape[:2]
    pixels = np.concatenate([a[name].reshape(*size, -1) for name in names], axis=2)
    features, labels = np.zeros((*size, 8), int), np.zeros(size, int)
    colours = a["colours"].tolist()
    for pixel in np.ndindex(size):
        values = (a["axes"] @ pixels[pixel] + a["offsets"]) >> 14
        features[pixel] = np.clip(values, 0, 255)
        red, green, blue = a["IDMASK"][pixel]
        colour = red + 256 * green + 65536 * blue
        labels[pixel] = 1 + colours.index(colour) if colour in colours else 0
    return {"features": features, "labels": labels}


STAGES = {
    "pack_stage": stage_pack_stage,
    "pack_all": stage_pack_all,
    "pack_principal": stage_pack_principal,
}
