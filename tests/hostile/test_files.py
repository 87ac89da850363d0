"""Hostile files and paths, one by one: a sentence and code 2, or what a user expects."""

import io
import json
import os
import pickle
import struct
import subprocess
import sys
import zlib
from contextlib import redirect_stderr

import numpy as np
import pytest
from exr_files import write_exr
from hostile.listed import Listed
from small_scene import small_scene

from stylit_ref import InputError, read_image, write_image
from stylit_ref.cli import main

CASES = {}
QUICK = ["--pyramid-levels", "2", "--search-vote-iters", "1", "--patchmatch-iters", "1", "--quiet"]


def case(title, gets, code=2):
    """List a generator that prepares the folder, yields more arguments, and looks at the outcome.

    Arguments that begin with a command are the whole command line.
    """

    def decorate(function):
        CASES[function] = Listed(title, gets, code)
        return function

    return decorate


@pytest.fixture(scope="module")
def scene():
    style, sources, targets = small_scene(source_size=(12, 13), target_size=(11, 14))
    images = {"style.png": style}
    for k in range(2):
        images |= {f"source_{k}.png": sources[k], f"target_{k}.png": targets[k]}
    return images


@pytest.fixture
def folder(tmp_path, scene, monkeypatch):
    for name, image in scene.items():
        write_image(tmp_path / name, image)
    nnf = np.random.default_rng(0).integers(2, 10, (11, 14, 2), np.int32)
    np.save(tmp_path / "nnf.npy", nnf)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def command(folder, more):
    if more[:1] == ["example"]:
        return [*map(str, more)]
    if more[:1] == ["replay"]:
        return ["replay", "--style", f"{folder}/style.png", *map(str, more[1:])]
    guides = [["--guide", f"{folder}/source_{k}.png", f"{folder}/target_{k}.png"] for k in range(2)]
    files = ["--style", f"{folder}/style.png", "--output", f"{folder}/out.png"]
    return ["run", *files, *guides[0], *guides[1], *QUICK, *map(str, more)]


def contents(folder):
    """Every file's name and bytes, links as such."""
    return {
        path: os.readlink(path) if path.is_symlink() else path.is_file() and path.read_bytes()
        for path in folder.rglob("*")
    }


# Images


def png(width, height, bits=8, colour=2, data=b""):
    def chunk(name, content):
        check = struct.pack(">I", zlib.crc32(name + content))
        return struct.pack(">I", len(content)) + name + content + check

    header = struct.pack(">IIBBBBB", width, height, bits, colour, 0, 0, 0)
    chunks = chunk(b"IHDR", header), chunk(b"IDAT", zlib.compress(data)), chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(chunks)


def tiff_of(width, height, file):
    """The bytes of a TIFF that declare another size."""
    content = bytearray(file.read_bytes())
    (first,) = struct.unpack_from("<I", content, 4)
    for entry in range(struct.unpack_from("<H", content, first)[0]):
        place = first + 2 + 12 * entry
        (tag,) = struct.unpack_from("<H", content, place)
        if tag in (256, 257):
            struct.pack_into("<HHII", content, place, tag, 4, 1, (width, height)[tag - 256])
    return content


def exr_of(window, size, file):
    """The bytes of an EXR whose data or display window declares another size."""
    content = bytearray(file.read_bytes())
    place = content.index(window + b"\0box2i\0") + len(window) + 11
    struct.pack_into("<4i", content, place, 0, 0, size[0] - 1, size[1] - 1)
    return content


def jpeg_of(width, height, file):
    content = bytearray(file.read_bytes())
    struct.pack_into(">HH", content, content.index(b"\xff\xc0") + 5, height, width)
    return content


def cut_in_half(file):
    file.write_bytes(file.read_bytes()[: file.stat().st_size // 2])


def style_as(folder, suffix):
    write_image(folder / f"style.{suffix}", read_image(folder / "style.png"))
    return folder / f"style.{suffix}"


@case("an image of 0 bytes", "style.png: cannot be read: …")
def empty(folder):
    (folder / "style.png").write_bytes(b"")
    yield []


@case("a PNG cut off in the middle", "style.png: cannot be read: …")
def cut_png(folder):
    cut_in_half(folder / "style.png")
    yield []


@case("a TIFF cut off in the middle", "style.tif: cannot be read: …")
def cut_tiff(folder):
    cut_in_half(style_as(folder, "tif"))
    yield ["--style", folder / "style.tif"]


@case("an EXR cut off in the middle", "style.exr: cannot be read: …")
def cut_exr(folder):
    cut_in_half(style_as(folder, "exr"))
    yield ["--style", folder / "style.exr"]


@case("a JPEG cut off, whose decoder makes up the rest", "style.jpg: cannot be read: …")
def cut_jpeg(folder):
    file = style_as(folder, "jpg")
    file.write_bytes(file.read_bytes()[:-20])
    yield ["--style", file]


@case("a PNG of 0 by 5 pixels", "style.png: cannot be read: …")
def no_pixels(folder):
    (folder / "style.png").write_bytes(png(0, 5))
    yield []


@case("a PNG of 65 bytes that declares 100000x100000 pixels", "style.png: cannot be read: …")
def png_bomb(folder):
    (folder / "style.png").write_bytes(png(100000, 100000))
    yield []


@case(
    "a PNG of 0.1 MB that unpacks to 30000x30000 pixels",
    "style.png: declares 30000x30000 pixels with 1 channels; at most 536870912 values are read",
)
def packed_bomb(folder):
    (folder / "style.png").write_bytes(png(30000, 30000, 1, 0, bytes(30000 * 3751)))
    yield []


@case("a TIFF that declares 100000x100000 pixels", "style.tif: cannot be read: …")
def tiff_bomb(folder):
    file = style_as(folder, "tif")
    file.write_bytes(tiff_of(100000, 100000, file))
    yield ["--style", file]


@case("a JPEG that declares 65500x65500 pixels", "style.jpg: cannot be read: …")
def jpeg_bomb(folder):
    file = style_as(folder, "jpg")
    file.write_bytes(jpeg_of(65500, 65500, file))
    yield ["--style", file]


@case("an EXR whose data window is 30000x30000", "style.exr: cannot be read: …")
def exr_bomb(folder):
    file = style_as(folder, "exr")
    file.write_bytes(exr_of(b"dataWindow", (30000, 30000), file))
    yield ["--style", file]


@case(
    "an EXR whose display window is 30000x30000, around few pixels",
    "style.exr: declares 30000x30000 pixels with 3 channels; at most 536870912 values are read",
)
def window_bomb(folder):
    file = style_as(folder, "exr")
    file.write_bytes(exr_of(b"displayWindow", (30000, 30000), file))
    yield ["--style", file]


BOMBS = (png_bomb, packed_bomb, tiff_bomb, jpeg_bomb, exr_bomb, window_bomb)


@case(
    "NaN or infinity in an EXR",
    "style.exr: 156 pixels are NaN or infinite, the first at (y, x) = (0, 0); all values must be "
    "finite",
)
def infinite(folder):
    write_exr(folder / "style.exr", {"R": np.inf, "G": 0, "B": 0}, (12, 13))
    yield ["--style", folder / "style.exr"]


@case("a text named .png", "style.png: cannot be read: …")
def text(folder):
    (folder / "style.png").write_text("no image")
    yield []


@case("a TIFF named .png", "read as the TIFF that it is", 0)
def wrong_suffix(folder):
    style_as(folder, "tif").replace(folder / "style.png")
    yield []
    assert read_image(folder / "out.png").shape == (11, 14, 3)


@case("a folder as an image", "levels.png: is a folder, not an image")
def folder_as_style(folder):
    (folder / "levels.png").mkdir()
    yield ["--style", folder / "levels.png"]


@case("a missing image", "none.png: no such file")
def missing(folder):
    yield ["--style", folder / "none.png"]


@case("a link to itself as an image", "loop.png: cannot be a file: …")
def loop(folder):
    (folder / "loop.png").symlink_to("loop.png")
    yield ["--style", folder / "loop.png"]


@case("a name of 300 letters", "…x.png: cannot be a file: File name too long")
def long_name(folder):
    yield ["--style", folder / f"{'x' * 300}.png"]


@case("a name that is no text in UTF-8", "…: cannot be a file: it is no text in UTF-8")
def no_text(folder):
    yield ["--style", f"{folder}/\udcff.png"]


# Outputs


def made(folder, name="out.png"):
    assert read_image(folder / name).shape == (11, 14, 3)


@case("names with spaces and Unicode", "used as they are", 0)
def unicode(folder):
    (folder / "style.png").rename(folder / "mein Stil, ψ 猫.png")
    yield ["--style", folder / "mein Stil, ψ 猫.png", "--output", folder / "à côté.png"]
    made(folder, "à côté.png")


@case("a name with a line break, of a file that is not there", "a b.png: no such file")
def line_break(folder):
    yield ["--style", folder / "a\nb.png"]


@case("a name that would act on the terminal", "a�[31m b λ 猫.png: no such file")
def terminal_codes(folder):
    yield ["--style", folder / "a\x1b[31m\rb\u3000λ 猫.png"]


@case("an option that would act on the terminal", "unrecognized arguments: --a b� …")
def terminal_codes_as_option(folder):
    yield ["--a\rb\x07"]


@case("a name with a line break", "used as it is", 0)
def good_line_break(folder):
    (folder / "style.png").rename(folder / "a\nb.png")
    yield ["--style", folder / "a\nb.png"]
    made(folder)


@case("a name that begins with a dash, after `=`", "used as it is", 0)
def dash(folder):
    yield ["--output=-out.png"]
    made(folder, "-out.png")


@case("a name that begins with a dash", "argument --output: expected one argument …")
def bare_dash(folder):
    yield ["--output", "-out.png"]


@case("an output that is a link to a file", "the file it leads to is replaced; the link stays", 0)
def link(folder):
    (folder / "deep").mkdir()
    (folder / "deep" / "real.png").write_bytes(b"old")
    (folder / "link.png").symlink_to("deep/real.png")
    yield ["--output", folder / "link.png"]
    assert (folder / "link.png").is_symlink()
    made(folder, "deep/real.png")


@case("an output that is a link to a file not yet there", "the file it leads to is made", 0)
def dangling(folder):
    (folder / "link.png").symlink_to("new.png")
    yield ["--output", folder / "link.png"]
    assert (folder / "link.png").is_symlink()
    made(folder, "new.png")


@case("an output that is a link into a missing folder", "link.png: the folder none does not exist")
def link_to_nowhere(folder):
    (folder / "link.png").symlink_to("none/new.png")
    yield ["--output", folder / "link.png"]


@case("an output that is a link to itself", "loop.png: cannot be a file: it is a link to itself")
def output_loop(folder):
    (folder / "loop.png").symlink_to("loop.png")
    yield ["--output", folder / "loop.png"]


@case("an output that is the style", "style.png: is read too; name another file")
def output_is_style(folder):
    yield ["--output", folder / "style.png"]


@case("an output that is a link to the style", "link.png: is read too; name another file")
def output_links_to_style(folder):
    (folder / "link.png").symlink_to("style.png")
    yield ["--output", folder / "link.png"]


@case("an output that is a hard link of the style", "a new file; the style keeps its bytes", 0)
def hard_link(folder):
    os.link(folder / "style.png", folder / "hard.png")
    before = (folder / "style.png").read_bytes()
    yield ["--output", folder / "hard.png"]
    assert (folder / "style.png").read_bytes() == before
    made(folder, "hard.png")


@case("a style that --save-levels would overwrite", "level_1.png: is read too; name another file")
def style_among_levels(folder):
    (folder / "style.png").rename(folder / "level_1.png")
    yield ["--style", folder / "level_1.png", "--save-levels", folder]


@case("an output among those of --save-levels", "level_2.png: is named twice; name another file")
def output_among_levels(folder):
    yield ["--output", folder / "level_2.png", "--save-levels", folder]


@case(
    "an output among the maps that --save-levels writes with --method guide_map",
    "guide_map_2.png: is named twice; name another file",
)
def output_among_maps(folder):
    output = folder / "guide_map_2.png"
    yield ["--output", output, "--save-levels", folder, "--method", "guide_map"]


@case("an output named as such a map, with another method", "written", 0)
def output_as_no_map(folder):
    yield ["--output", folder / "guide_map_2.png", "--save-levels", folder]
    made(folder, "guide_map_2.png")


@case("an output that is a folder", "made.png: is a folder; name a file")
def output_folder(folder):
    (folder / "made.png").mkdir()
    yield ["--output", folder / "made.png"]


@case("an output that is a pipe, or a device", "pipe.png: is no regular file")
def pipe(folder):
    os.mkfifo(folder / "pipe.png")
    yield ["--output", folder / "pipe.png"]


@case("a saved field that is a pipe, or a device", "pipe.npy: is no regular file")
def pipe_as_saved_field(folder):
    os.mkfifo(folder / "pipe.npy")
    yield ["--nnf", folder / "pipe.npy"]


@case("an output where nothing can be made", "/proc/out.png: cannot be written: …")
def proc(folder):
    yield ["--output", "/proc/out.png"]


@case(
    "an output of a format that makes no file",
    "out.null: no image format is known by the suffix '.null'; use .png, .tif or .exr",
)
def null(folder):
    yield ["--output", folder / "out.null"]


# Nearest-neighbour fields


def replayed(folder, content):
    (folder / "hostile.npy").write_bytes(content)
    return ["replay", "--nnf", folder / "hostile.npy", "--output", folder / "out.png"]


def saved(array, **options):
    file = io.BytesIO()
    np.save(file, array, **options)
    return file.getvalue()


class Trap:
    """Unpickling it would make a file."""

    def __reduce__(self):
        return open, ("trapped", "w")


@case("a field that is a pipe, or a device", "pipe.npy: is no regular file")
def field_from_pipe(folder):
    os.mkfifo(folder / "pipe.npy")
    yield ["replay", "--nnf", folder / "pipe.npy", "--output", folder / "out.png"]


@case("a field with pickled objects", "hostile.npy: is not a readable .npy file: …")
def pickled_objects(folder):
    yield replayed(folder, saved(np.array([Trap()], object), allow_pickle=True))


@case("a pickle in the place of a field", "hostile.npy: is not a readable .npy file: …")
def bare_pickle(folder):
    yield replayed(folder, pickle.dumps(Trap()))


@case("an .npz in the place of a field", "hostile.npy: is not a readable .npy file: …")
def npz(folder):
    file = io.BytesIO()
    np.savez(file, nnf=np.zeros((4, 4, 2), np.int32))
    yield replayed(folder, file.getvalue())


@case("a field cut off in the middle", "hostile.npy: is not a readable .npy file: …")
def cut_field(folder):
    yield replayed(folder, (folder / "nnf.npy").read_bytes()[:300])


@case("a field whose header declares 8 TB", "hostile.npy: is not a readable .npy file: …")
def field_bomb(folder):
    content = saved(np.zeros((4, 4, 2), np.int32))
    yield replayed(
        folder, content.replace(b"(4, 4, 2), }            ", b"(1000000, 1000000, 2), }")
    )


@case(
    "a field of floating point",
    "the NNF is float64 of shape (4, 4, 2); it must be int32 of shape (H, W, 2)",
)
def float_field(folder):
    yield replayed(folder, saved(np.zeros((4, 4, 2))))


@case(
    "a field of another byte order",
    "the NNF is >i4 of shape (4, 4, 2); it must be int32 of shape (H, W, 2)",
)
def swapped(folder):
    yield replayed(folder, saved(np.full((4, 4, 2), 3, ">i4")))


@case("a field in Fortran order", "replayed as any other", 0)
def fortran(folder):
    yield replayed(folder, saved(np.asfortranarray(np.load(folder / "nnf.npy"))))
    ours = read_image(folder / "out.png")
    assert main(command(folder, replayed(folder, (folder / "nnf.npy").read_bytes()))) == 0
    np.testing.assert_array_equal(ours, read_image(folder / "out.png"))


@case(
    "a field that points outside the style",
    "the NNF points to source pixels (y, x) from [99, 99] to [99, 99], but a style of 13x12 at "
    "scale 1 has patches of width 5 only from [2, 2] to [9, 10]",
)
def outside(folder):
    yield replayed(folder, saved(np.full((4, 4, 2), 99, np.int32)))


# Folders


@case("`example` into a folder of 300 letters", "…x: cannot be a file: File name too long")
def example_of_long_name(folder):
    yield ["example", folder / ("x" * 300)]


@case(
    "`example` into a folder whose name is no text in UTF-8",
    "…: cannot be a file: it is no text in UTF-8",
)
def example_of_no_text(folder):
    yield ["example", f"{folder}/a\udcffb"]


@case("`example` into a file", "style.png/new: cannot be written: Not a directory")
def example_in_file(folder):
    yield ["example", folder / "style.png" / "new"]


@pytest.mark.parametrize("prepare", CASES, ids=lambda prepare: prepare.__name__)
def test_each_gets_what_is_listed(folder, prepare):
    steps, said = prepare(folder), io.StringIO()
    arguments = command(folder, next(steps))
    before = contents(folder)
    with redirect_stderr(said):
        try:
            code = main(arguments)
        except SystemExit as stop:
            code = stop.code
    CASES[prepare].check(code, said.getvalue(), folder)
    if code:
        assert contents(folder) == before
        assert said.getvalue().count("\n") == 1
    next(steps, None)


@pytest.mark.parametrize("suffix", ["png", "tif", "exr", "jpg"])
def test_no_part_of_an_image_is_an_image(folder, suffix):
    """But for the last bytes of some formats, behind all pixels."""
    file = style_as(folder, suffix)
    content, image = file.read_bytes(), read_image(file)
    for length in range(0, len(content), max(1, len(content) // 60)):
        file.write_bytes(content[:length])
        try:
            read = read_image(file)
        except InputError:
            continue
        assert length > len(content) - 20
        np.testing.assert_array_equal(read, image)


# Not by getrusage: a process begins with the peak of the one that started it.
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


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="measured by Linux' /proc")
def test_bombs_are_refused_before_memory_is_taken(folder):
    """The smallest of them would take 900 MB; 32 are allowed, for the library's own pages."""
    files = []
    for bomb in BOMBS:
        steps = bomb(folder)
        style = (next(steps) or [None, folder / "style.png"])[1]
        files.append(str(style.rename(folder / f"{bomb.__name__}{style.suffix}")))
        write_image(folder / "style.png", np.zeros((12, 13, 3), np.uint8))
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


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="measured by Linux' /proc")
@pytest.mark.parametrize(
    ("suffix", "dtype", "times"),
    [("png", "uint8", 2), ("tif", "uint16", 2), ("exr", "float32", 2), ("pfm", "float32", 3)],
)
def test_reading_takes_two_to_three_times_the_memory_of_the_image(tmp_path, suffix, dtype, times):
    """As is said of LARGEST_IMAGE; a quarter is allowed for the library's own pages."""
    file = tmp_path / f"a.{suffix}"
    image = np.random.default_rng(0).integers(0, 2, (2500, 2500, 3)).astype(dtype)
    write_image(file, image)
    done = subprocess.run([sys.executable, "-c", _MEASURES, file], capture_output=True, check=True)
    assert int(done.stdout) < (times + 0.25) * image.nbytes


TOO_LARGE = Listed(
    "images that memory has no room for", "there is not enough memory for images of this size"
)
_RUNS = """
import resource, sys
from stylit_ref.cli import main
size = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (size + (64 << 20),) * 2)
sys.exit(main(sys.argv[1:]))
"""


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="measured by Linux' /proc")
def test_too_little_memory_is_said(folder):
    write_image(folder / "style.png", np.zeros((6000, 6000, 3), np.uint8))
    arguments = command(folder, [])
    done = subprocess.run([sys.executable, "-c", _RUNS, *arguments], capture_output=True, text=True)
    TOO_LARGE.check(done.returncode, done.stderr, folder)
    assert not (folder / "out.png").exists()


_WRITES = """
import resource, sys
from stylit_ref.cli import main
resource.setrlimit(resource.RLIMIT_FSIZE, (5000, 5000))
sys.exit(main(sys.argv[1:]))
"""
SHORT_FILE = Listed(
    "a disk that takes a part of a file, though it says that it has room",
    "out.…: cannot be written: …",
)


@pytest.mark.parametrize("suffix", ["png", "tif", "exr", "bmp", "tga"])
def test_a_file_that_cannot_be_finished_is_not_there(folder, suffix):
    """Some libraries write a broken file without a word.

    Not of JPEG and WebP: there libraries end the process, or try for ever.
    """
    rng = np.random.default_rng(0)
    write_image(folder / "style.png", rng.integers(0, 256, (50, 60, 3), dtype=np.uint8))
    np.save(folder / "nnf.npy", rng.integers(2, 48, (90, 80, 2), np.int32))
    before = contents(folder)
    replay = ["replay", "--nnf", folder / "nnf.npy", "--output", folder / f"out.{suffix}"]
    call = [sys.executable, "-c", _WRITES, *command(folder, replay)]
    done = subprocess.run(call, capture_output=True, text=True)
    SHORT_FILE.check(done.returncode, done.stderr, folder)
    assert contents(folder) == before


OTHERS = [TOO_LARGE, SHORT_FILE]
"""Listed, and tested on their own."""
