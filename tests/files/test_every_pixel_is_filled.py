"""No value of an image is what lay in memory before it was read.

Two processes read the same files. The C library of each fills new memory with another byte, so a
value that nobody has written differs between the two.
"""

import json
import os
import platform
import subprocess
import sys

import numpy as np
import OpenImageIO as oiio
import pytest
from exr_files import write_deep, write_exr, write_parts

from stylit_ref import read_image, write_image

READER = """
import hashlib, json, sys
import numpy as np
from stylit_ref import InputError, read_image

def digest(path):
    try:
        return hashlib.sha256(np.ascontiguousarray(read_image(path))).hexdigest()
    except InputError as error:
        return "refused: " + error.sentence

read = {path: digest(path) for path in sys.argv[1:]}
print(json.dumps({"poison": int(np.empty(100_000, np.uint8)[50_000]), "read": read}))
"""

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="only glibc fills new memory"),
]


def read_in_poisoned_memory(files, byte):
    """What a process reads from the files, and what it finds in new memory."""
    # A whole number from 1 to 255: new memory is filled with its complement.
    environment = os.environ | {"MALLOC_PERTURB_": str(255 - byte)}
    command = [sys.executable, "-c", READER, *map(str, files)]
    printed = subprocess.run(command, env=environment, check=True, capture_output=True).stdout
    return json.loads(printed)


def check_filled(files):
    """Read the files twice, and return what was read of them, in their order."""
    once, again = (read_in_poisoned_memory(files, byte) for byte in (33, 99))
    assert (once["poison"], again["poison"]) == (33, 99)
    assert once["read"] == again["read"]
    return [once["read"][str(file)] for file in files]


def write_by_every_writer(folder):
    """A file of every kind, depth and number of channels that OpenImageIO can write."""
    pixels = np.random.default_rng(0).random((66, 70, 4), np.float32)
    suffixes = dict(
        entry.split(":") for entry in oiio.get_string_attribute("extension_list").split(";")
    )
    kinds = oiio.get_string_attribute("output_format_list").split(",")
    files = []
    for kind in set(kinds) - {"null", "term"}:
        for suffix in suffixes[kind].split(","):
            for depth in ("uint8", "uint16", "half", "float"):
                for channels in (1, 2, 3, 4):
                    file = folder / f"{depth}_{channels}.{suffix}"
                    if write(file, oiio.ImageSpec(70, 66, channels, depth), pixels[..., :channels]):
                        files.append(file)
    return files


def write(file, spec, pixels):
    """Whether OpenImageIO can write that file."""
    output = oiio.ImageOutput.create(str(file))
    if output is None:
        oiio.geterror()
        return False
    try:
        written = output.open(str(file), spec) and output.write_image(pixels)
    except RuntimeError:  # of OpenJPH
        return False
    return output.close() and written


def test_every_kind_of_file(tmp_path):
    files = write_by_every_writer(tmp_path)
    assert len({file.suffix for file in files}) > 20
    read = check_filled(files)
    assert sum(not each.startswith("refused") for each in read) > len(files) // 2


def test_files_that_end_early(tmp_path):
    files = write_by_every_writer(tmp_path)
    for file in files:
        content = file.read_bytes()
        file.write_bytes(content[: len(content) * 2 // 3])
    assert all(each.startswith("refused: ") for each in check_filled(files))


def test_exr_files_of_every_layout(tmp_path):
    layers = {"A.R": 0.1, "A.G": 0.2, "A.B": 0.3, "B.Z": 4.0}
    files = [
        write_exr(tmp_path / "inside.exr", layers, data_window=(2, 1, 12, 10)),
        write_exr(tmp_path / "overlaps.exr", layers, data_window=(-3, -1, 12, 10)),
        write_exr(tmp_path / "outside.exr", layers, data_window=(20, 20, 12, 10)),
    ]
    for compression in (
        "none",
        "rle",
        "zips",
        "zip",
        "piz",
        "pxr24",
        "b44",
        "b44a",
        "dwaa",
        "dwab",
    ):
        for tile in (0, 16):
            spec = oiio.ImageSpec(70, 66, 3, "half")
            spec.attribute("compression", compression)
            spec.tile_width = spec.tile_height = tile
            image = oiio.ImageBuf(spec)
            image.set_pixels(image.roi, np.random.default_rng(0).random((66, 70, 3), np.float32))
            file = tmp_path / f"{compression}_{tile}.exr"
            assert image.write(str(file))
            files.append(file)
    parts = write_parts(tmp_path / "parts.exr", {"beauty": 0.25, "LDE": 0.5})
    named = [f"{file}:A" for file in files[:3]] + [f"{parts}:beauty", f"{parts}:LDE"]
    assert not any(
        each.startswith("refused") for each in check_filled([*named, *map(str, files[3:])])
    )


def test_a_deep_file_is_refused_with_a_remedy(tmp_path):
    file = write_deep(tmp_path / "deep.exr")
    said = f"{file}: holds deep pixels; flatten it first: oiiotool {file} --flatten -o flat.exr"
    assert check_filled([file]) == [f"refused: {said}"]


def test_the_remedy_for_a_deep_file_works(tmp_path):
    deep = oiio.ImageBuf(str(write_deep(tmp_path / "deep.exr")))
    assert oiio.ImageBufAlgo.flatten(deep).write(str(tmp_path / "flat.exr"))
    np.testing.assert_array_equal(read_image(tmp_path / "flat.exr")[2, 3], [0.25, 0.5, 0.75])


def test_the_poison_shows_what_nobody_wrote(tmp_path, monkeypatch):
    """A reader that leaves a value out is found."""
    write_image(tmp_path / "a.png", np.zeros((60, 60, 3), np.uint8))
    leaves_out = "np.empty(11_000, np.uint8) if 'a.png' in path else read_image(path)"
    monkeypatch.setattr(
        sys.modules[__name__], "READER", READER.replace("read_image(path)", leaves_out)
    )
    with pytest.raises(AssertionError):
        check_filled([tmp_path / "a.png"])
