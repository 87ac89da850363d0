"""Hostile images: damaged files, files that declare huge sizes, images too large for memory."""

import json
import os
import struct
import subprocess
import sys
import zlib
from pathlib import Path

import numpy as np
import pytest
from exr_files import write_exr
from hostile.command_line import accepted, check, contents, refused, run

from stylit_ref import InputError, read_image, write_image

UNREADABLE = "cannot be read: …"
TOO_MANY_VALUES = (
    "declares 30000x30000 pixels with {} channels; at most 536870912 values "
    "(width x height x channels) can be read; make it smaller"
)
NEEDS_PROC = pytest.mark.skipif(
    not os.path.exists("/proc/self/statm"), reason="measured by Linux' /proc"
)


def style_as(suffix):
    """The style written in another format."""
    file = Path(f"style.{suffix}")
    write_image(file, read_image("style.png"))
    return file


def png(width, height, bits=8, colour=2, data=b""):
    def chunk(name, content):
        check = struct.pack(">I", zlib.crc32(name + content))
        return struct.pack(">I", len(content)) + name + content + check

    header = struct.pack(">IIBBBBB", width, height, bits, colour, 0, 0, 0)
    chunks = chunk(b"IHDR", header), chunk(b"IDAT", zlib.compress(data)), chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunks)


def tiff_of(width, height):
    """The bytes of a TIFF that declare another size."""
    content = bytearray(style_as("tif").read_bytes())
    (first,) = struct.unpack_from("<I", content, 4)
    for entry in range(struct.unpack_from("<H", content, first)[0]):
        place = first + 2 + 12 * entry
        (tag,) = struct.unpack_from("<H", content, place)
        if tag in (256, 257):
            struct.pack_into("<HHII", content, place, tag, 4, 1, (width, height)[tag - 256])
    return content


def exr_of(window, width, height):
    """The bytes of an EXR whose data or display window declares another size."""
    content = bytearray(style_as("exr").read_bytes())
    place = content.index(window + b"\0box2i\0") + len(window) + 11
    struct.pack_into("<4i", content, place, 0, 0, width - 1, height - 1)
    return content


def jpeg_of(width, height):
    content = bytearray(style_as("jpg").read_bytes())
    struct.pack_into(">HH", content, content.index(b"\xff\xc0") + 5, height, width)
    return content


BOMBS = {
    "65 bytes of PNG": ("png", lambda: png(100000, 100000), UNREADABLE),
    "0.1 MB of PNG that unpack": (
        "png",
        lambda: png(30000, 30000, 1, 0, bytes(30000 * 3751)),
        TOO_MANY_VALUES.format(1),
    ),
    "TIFF": ("tif", lambda: tiff_of(100000, 100000), UNREADABLE),
    "JPEG": ("jpg", lambda: jpeg_of(65500, 65500), UNREADABLE),
    "EXR": ("exr", lambda: exr_of(b"dataWindow", 30000, 30000), UNREADABLE),
    "EXR with a wide frame": (
        "exr",
        lambda: exr_of(b"displayWindow", 30000, 30000),
        TOO_MANY_VALUES.format(3),
    ),
}
"""Small files that declare more pixels than memory holds."""


@pytest.mark.parametrize("bomb", BOMBS)
def test_a_small_file_that_declares_a_huge_image(folder, bomb):
    suffix, content, sentence = BOMBS[bomb]
    file = Path(f"style.{suffix}")
    file.write_bytes(content())
    refused(run("--style", str(file)), f"{file}: {sentence}")


@pytest.mark.parametrize("suffix", ["png", "tif", "exr"])
def test_an_image_cut_off_in_the_middle(folder, suffix):
    file = style_as(suffix)
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])
    refused(run("--style", str(file)), f"{file}: {UNREADABLE}")


def test_a_jpeg_cut_off_whose_decoder_makes_up_the_rest(folder):
    file = style_as("jpg")
    file.write_bytes(file.read_bytes()[:-20])
    refused(run("--style", "style.jpg"), f"style.jpg: {UNREADABLE}")


@pytest.mark.parametrize(
    "content", [b"", png(0, 5), b"no image"], ids=["empty", "of no pixels", "a text"]
)
def test_what_is_no_image(folder, content):
    Path("style.png").write_bytes(content)
    refused(run(), f"style.png: {UNREADABLE}")


def test_nan_or_infinity_in_an_exr(folder):
    write_exr("style.exr", {"R": np.inf, "G": 0, "B": 0}, (12, 13))
    refused(
        run("--style", "style.exr"),
        "style.exr: 156 pixels are NaN or infinite, the first at (y, x) = (0, 0); all values must "
        "be finite",
    )


def test_a_tiff_named_png_is_read_as_the_tiff_that_it_is(folder):
    style_as("tif").replace("style.png")
    accepted(run())
    assert read_image("out.png").shape == (11, 14, 3)


@pytest.mark.parametrize("suffix", ["png", "tif", "exr", "jpg"])
def test_no_part_of_an_image_is_an_image(folder, suffix):
    """Except for the last bytes of some formats, which come after all pixels."""
    file = style_as(suffix)
    content, image = file.read_bytes(), read_image(file)
    for length in range(0, len(content), max(1, len(content) // 60)):
        file.write_bytes(content[:length])
        try:
            read = read_image(file)
        except InputError:
            continue
        assert length > len(content) - 20
        np.testing.assert_array_equal(read, image)


# Memory. getrusage does not help: a process begins with the peak of its parent.

_PEAK = """
import re
def peak():
    return int(re.search(r"VmHWM:\\s+(\\d+) kB", open("/proc/self/status").read())[1]) << 10
"""
_READS = f"""{_PEAK}
import json, resource, sys
from stylit_ref import InputError, read_image
size = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (size + (256 << 20),) * 2)
before, refused = peak(), []
for file in sys.argv[1:]:
    try:
        read_image(file)
    except InputError as error:
        refused.append(file)
print(json.dumps([refused, peak() - before]))
"""


@NEEDS_PROC
@pytest.mark.slow
def test_huge_images_are_refused_before_memory_is_taken(folder):
    """The smallest image would take 900 MB; 32 MB are allowed for the library itself."""
    files = []
    for number, (suffix, content, _) in enumerate(BOMBS.values()):
        files.append(f"{number}.{suffix}")
        Path(files[-1]).write_bytes(content())
    done = subprocess.run([sys.executable, "-c", _READS, *files], capture_output=True, check=True)
    refused, taken = json.loads(done.stdout)
    assert refused == files
    assert taken < 32 << 20


_MEASURES = f"""{_PEAK}
import sys
from stylit_ref import read_uint8
before = peak()
read_uint8(sys.argv[1])
print(peak() - before)
"""


@NEEDS_PROC
@pytest.mark.slow
@pytest.mark.parametrize(
    ("suffix", "dtype", "times"),
    [("png", "uint8", 2), ("tif", "uint16", 2), ("exr", "float32", 2), ("pfm", "float32", 3)],
)
def test_reading_takes_two_to_three_times_the_memory_of_the_image(tmp_path, suffix, dtype, times):
    """The docstring of LARGEST_IMAGE says so; a quarter more is allowed for the library itself."""
    file = tmp_path / f"a.{suffix}"
    image = np.random.default_rng(0).integers(0, 2, (2500, 2500, 3)).astype(dtype)
    write_image(file, image)
    done = subprocess.run([sys.executable, "-c", _MEASURES, file], capture_output=True, check=True)
    assert int(done.stdout) < (times + 0.25) * image.nbytes


_RUNS = """
import resource, sys
from stylit_ref.cli import main
size = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (size + (64 << 20),) * 2)
sys.exit(main(sys.argv[1:]))
"""


@NEEDS_PROC
@pytest.mark.slow
def test_too_little_memory_is_said(folder):
    write_image("style.png", np.zeros((6000, 6000, 3), np.uint8))
    before = contents(folder)
    done = subprocess.run([sys.executable, "-c", _RUNS, *run()], capture_output=True, text=True)
    check(done.returncode, done.stderr, "there is not enough memory for images of this size")
    assert contents(folder) == before
