"""Every command of README and docs is run; what cannot be says why in its own fence.

A fence's first word is its language, the rest how it is run: ``sh`` in bash, ``python`` by the
interpreter, ``sh dry-run`` with make printing its commands only, ``sh not-run: REASON`` not at all,
``renders`` where the renderer is installed. A ``text`` fence after one holds lines that it must
print, ``...`` for anything. The blocks of a page run one after another in one shell; each begins in
a folder that links to the repository.
"""

import os
import re
import shutil
import signal
import socket
import subprocess
import sys
from contextlib import suppress
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from exr_files import write_exr
from markdown_it import MarkdownIt
from skimage.io import imsave
from small_run import write_run

from data_gen.guides import LIGHT_PASSES
from data_gen.multilayer_exr import write_layers
from data_gen.renderer import MissingRendererError, start
from data_gen.textures import make_texture
from oracle.families import STYLIZATION
from stylit_ref import Params, read_uint8
from stylit_ref.cli import main
from stylit_ref.cli.parser import EBSYNTH
from stylit_ref.files.colour.bit_depth import to_linear
from stylit_ref.files.motion_flo import write_flo
from stylit_ref.metric.packing import ONE, make_packing

ROOT = Path(__file__).parents[2]
PAGES = [
    str(file.relative_to(ROOT)) for file in (ROOT / "README.md", *sorted(ROOT.glob("docs/**/*.md")))
]
LANGUAGES = ("sh", "python")
NO_COMMANDS = ("text", "json", "{toctree}", "{eval-rst}")
RUN, DRY_RUN, RENDERS = "", "dry-run", "renders"
NOT_RUN = (
    "not-run: installs packages",
    "not-run: needs a GPU",
    "not-run: needs Blender",
    "not-run: needs ffmpeg",
    "not-run: writes the cases anew",
    "not-run: serves until it is interrupted",
)
HELP = {
    "stylit-ref run": "stylit_ref.cli run",
    "stylit-ref sequence": "stylit_ref.cli sequence",
    "stylit-ref studio": "stylit_ref.cli studio",
    "stylit-ref view": "stylit_ref.cli view",
    "stylit-ref views": "stylit_ref.cli views",
    "stylit-ref texture": "stylit_ref.cli texture",
    "stylit-ref edit-texture": "stylit_ref.cli edit-texture",
    "stylit-ref replay-texture": "stylit_ref.cli replay-texture",
    "python -m eval dzurenko": "eval dzurenko",
    "python -m eval gpu": "eval gpu",
    "python -m data_gen": "data_gen",
}
"""Commands whose flags can be asked for without running them, and the module that tells."""


class Block(NamedTuple):
    """A fence: what it holds, how it is run, and lines that it must print."""

    language: str
    how: str
    code: str
    printed: list[str]


def tokens_of(page, kind):
    """Markdown's tokens of a kind, those within a line of text too."""
    tokens = MarkdownIt().parse((ROOT / page).read_text(encoding="utf-8"))
    return [
        token
        for block in tokens
        for token in (block, *(block.children or ()))
        if token.type == kind
    ]


def blocks_of(page):
    """The blocks of a page that are commands."""
    for fence, after in pairwise([*tokens_of(page, "fence"), None]):
        language, _, how = fence.info.strip().partition(" ")
        if language in LANGUAGES:
            printed = after.content.splitlines() if after and after.info == "text" else []
            yield Block(language, how, fence.content, printed)


@pytest.fixture
def scratch(tmp_path):
    """The repository as a reader's folder with an environment; what is written stays here."""
    (tmp_path / "reports").mkdir()
    for entry in (*ROOT.iterdir(), *(ROOT / "reports").iterdir()):
        if entry.name not in ("build", "reports") and not entry.name.startswith("."):
            (tmp_path / entry.relative_to(ROOT)).symlink_to(entry)
    environment = tmp_path / ".venv"
    (environment / "bin").mkdir(parents=True)
    (environment / "bin" / "activate").touch()
    python = environment / "bin" / "python"
    python.write_text(f'#!/bin/sh\nexec "{sys.executable}" "$@"\n', encoding="utf-8")
    python.chmod(0o755)
    (environment / "cluster.installed").touch()
    (tmp_path / "build").mkdir()
    return tmp_path


def small(name):
    """Every third pixel of a bundled image."""
    return read_uint8(ROOT / "data_gen" / "bundled" / name)[::3, ::3]


def passes_of_blender(scratch):
    """Renders as Blender names their layers, and a painting."""
    names = {"Combined": "FULL", "DiffDir": "LDE", "GlossDir": "LSE", "DiffInd": "LDDE"}
    for file, scene in (("sphere", "source"), ("golem", "golem")):
        channels = {}
        for layer, guide in names.items():
            image = to_linear(small(f"{scene}/{guide}.png"))
            channels |= {f"ViewLayer.{layer}.{c}": image[..., k] for k, c in enumerate("RGB")}
        channels |= {f"ViewLayer.DiffCol.{c}": 0.5 for c in "RGB"}
        ids = small(f"{scene}/IDMASK.png") / 255
        channels |= {f"ViewLayer.ID.{c}": ids[..., k] for k, c in enumerate("RGB")}
        channels["ViewLayer.IndexOB.X"] = np.round(ids @ (1, 2, 4))
        write_exr(scratch / f"{file}.exr", channels, ids.shape[:2])
    imsave(scratch / "painted.png", small("source/styles/oil.png"), check_contrast=False)


def shot_of_blender(scratch):
    """Frames of a camera that pans faster and faster, with Blender's vectors."""
    places = [0, 1, 3, 6, 10]
    names = {"Combined": "FULL", "DiffDir": "LDE", "GlossDir": "LSE", "DiffInd": "LDDE"}
    passes = {layer: to_linear(small(f"golem/{name}.png")) for layer, name in names.items()}
    ids = np.round(small("golem/IDMASK.png") / 255 @ (1, 2, 4))
    (scratch / "shot").mkdir()
    for frame in (1, 2, 3):
        x, y = places[frame], places[frame] // 2
        channels = {}
        for layer, still in passes.items():
            image = np.roll(still, (y, x), axis=(0, 1))
            channels |= {f"ViewLayer.{layer}.{c}": image[..., k] for k, c in enumerate("RGB")}
        channels["ViewLayer.IndexOB.X"] = np.roll(ids, (y, x), axis=(0, 1))
        channels["ViewLayer.Depth.Z"] = 10.0
        for pair, (first, second) in (("XY", (frame - 1, frame)), ("ZW", (frame, frame + 1))):
            channels[f"ViewLayer.Vector.{pair[0]}"] = places[first] - places[second]
            channels[f"ViewLayer.Vector.{pair[1]}"] = places[second] // 2 - places[first] // 2
        file = scratch / "shot" / f"scene.{frame:04d}.exr"
        write_exr(file, channels, ids.shape, depth="float")


def renders_of_script(scratch):
    """What ``render_passes.py`` writes: the shot and the sphere, in one folder."""
    passes_of_blender(scratch)
    shot_of_blender(scratch)
    (scratch / "renders").mkdir()
    (scratch / "sphere.exr").rename(scratch / "renders" / "sphere.0001.exr")
    for frame in (scratch / "shot").iterdir():
        frame.rename(scratch / "renders" / frame.name.replace("scene", "shot"))


def grid_of_house(scratch):
    """The manifest that the page shows."""
    page = (ROOT / "docs/how_to/sequences.md").read_text(encoding="utf-8")
    (scratch / "grid.json").write_text(re.search(r"```json\n(.*?)```", page, re.DOTALL)[1])


def video_of_ezsynth(scratch):
    """Frames of a camera that pans, their flow, and two of them painted over."""
    for folder in ("video", "flow", "painted"):
        (scratch / folder).mkdir()
    still, painting = small("golem/FULL.png"), small("source/styles/oil.png")
    for frame in (1, 2, 3):
        moved = np.roll(still, 2 * frame, axis=1)
        imsave(scratch / f"video/{frame:04d}.png", moved, check_contrast=False)
        flow = np.full((*still.shape[:2], 2), (2, 0), np.float32)
        write_flo(scratch / f"flow/{frame:04d}.flo", flow)
    for frame in (1, 3):
        moved = np.roll(painting, 2 * frame, axis=1)
        imsave(scratch / f"painted/{frame:04d}.png", moved, check_contrast=False)


def images_of_texture_synthesis(scratch):
    """An exemplar, and one with a hole that is black in its mask."""
    (scratch / "imgs").mkdir()
    pebbles = make_texture("pebbles", 128)
    for number in (1, 3):
        imsave(scratch / f"imgs/{number}.jpg", pebbles, check_contrast=False)
    hole = np.full((128, 128), 255, np.uint8)
    hole[30:60, 40:70] = 0
    imsave(scratch / "imgs/3_inpaint.png", hole, check_contrast=False)


def rule_of_guides(scratch):
    """What ``--nnf`` keeps of how guides are encoded."""
    line = ["--preset", "fast", "--style", f"{scratch}/painted.png", "--quiet"]
    line += ["--guide", f"{scratch}/sphere.exr", f"{scratch}/shot/scene.0001.exr"]
    line += ["--guide-layers", "Combined,IndexOB", "--nnf", f"{scratch}/first.npy"]
    assert main(["run", *line, "--output", f"{scratch}/first.png"]) == 0


def rendered_passes(scratch):
    """Layers where ``make data`` puts them, and the files beside."""
    for scene in ("source", "teapot"):
        folder = scratch / "build/data/300x228" / scene
        folder.mkdir(parents=True)
        layers = {name: to_linear(small(f"{scene}/{name}.png")) for name in LIGHT_PASSES}
        write_layers(folder / "passes.exr", layers)
    styles = scratch / "build/data/300x228/source/styles"
    styles.mkdir()
    imsave(styles / "oil.png", small("source/styles/oil.png"), check_contrast=False)


def images_of_ebsynth(scratch):
    """The example of ebsynth's own README: three guides and a style."""
    for place, scene in (("source", "source"), ("target", "golem")):
        for name, guide in (("fullgi", "FULL"), ("dirdif", "LDE"), ("indirb", "LDDE")):
            image = small(f"{scene}/{guide}.png")
            imsave(scratch / f"{place}_{name}.png", image, check_contrast=False)
    imsave(scratch / "source_style.png", small("source/styles/oil.png"), check_contrast=False)


def own_images(scratch):
    """A painting, the renders it belongs to, and their objects in flat colours."""
    for name, image in (
        ("painted", "source/styles/oil"),
        ("sphere", "source/FULL"),
        ("scene", "golem/FULL"),
        ("sphere_ids", "source/IDMASK"),
        ("scene_ids", "golem/IDMASK"),
    ):
        imsave(scratch / f"{name}.png", small(f"{image}.png"), check_contrast=False)


def run_of_a_box(scratch):
    """A RUN that holds a mesh."""
    write_run(scratch / "build" / "run")


PREPARED = {
    "docs/how_to/blender.md": (renders_of_script,),
    "README.md": (own_images,),
    "docs/how_to/renderer_passes.md": (passes_of_blender, rendered_passes),
    "docs/how_to/sequences.md": (passes_of_blender, shot_of_blender, grid_of_house),
    "docs/how_to/render_farm.md": (passes_of_blender, shot_of_blender, rule_of_guides),
    "docs/how_to/from_ebsynth.md": (images_of_ebsynth,),
    "docs/how_to/from_ezsynth.md": (video_of_ezsynth,),
    "docs/how_to/from_texture_synthesis.md": (images_of_texture_synthesis,),
    "docs/how_to/views_between.md": (run_of_a_box,),
    "docs/how_to/viewer.md": (run_of_a_box,),
}


def here(page, code):
    """A page's code with this machine in the places of a cluster's."""
    if page not in ("docs/how_to/cluster.md", "docs/how_to/render_farm.md"):
        return code
    return code.replace("--port 8786", f"--host 127.0.0.1 --port {PORT}").replace(
        "head:8786", f"127.0.0.1:{PORT}"
    )


def free_port():
    """A port that nobody listens on."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


PORT = free_port()


def script(page, blocks):
    """A page as a bash script, and a line before each block's output."""
    lines = ["set -eo pipefail", "BEGINNING=$PWD"]
    for number, block in enumerate(blocks):
        lines += [f"echo '== block {number} =='", 'cd "$BEGINNING"']
        code = here(page, block.code)
        if block.language == "python":
            lines += ["python - <<'END OF BLOCK'", code, "END OF BLOCK"]
        elif block.how == DRY_RUN:
            lines += ["export MAKEFLAGS=n", code, "unset MAKEFLAGS"]
        elif block.how not in NOT_RUN:
            lines.append(code)
    return "\n".join(lines) + "\n"


def run(page, blocks, folder):
    """What each block of a page prints."""
    environment = os.environ | {
        "MAKEFLAGS": "",  # what make test was given is not for a page's make
        "ARGS": "",
        "PATH": f"{folder}/.venv/bin:{Path(sys.executable).parent}:{os.environ['PATH']}",
        "PYTHONPATH": os.pathsep.join(filter(None, [str(ROOT), os.environ.get("PYTHONPATH")])),
    }
    log = folder / "build" / "log"
    with log.open("wb") as output:
        shell = subprocess.Popen(
            ["bash", "-c", script(page, blocks)],
            cwd=folder, env=environment, stdin=subprocess.DEVNULL,
            stdout=output, stderr=subprocess.STDOUT, start_new_session=True,
        )  # fmt: skip
        try:
            code = shell.wait(timeout=900)
        finally:  # what a page started in the background ends with it
            with suppress(ProcessLookupError):
                os.killpg(shell.pid, signal.SIGKILL)
    text = log.read_text(encoding="utf-8")
    assert code == 0, f"{page}: exit code {code}:\n{text}"
    return re.split(r"== block \d+ ==\n", text)[1:]


@cache
def flags_of(module):
    """Every flag that the help of a command names."""
    command = [sys.executable, "-m", *module.split(), "--help"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    return set(re.findall(r"--[a-z-]+", done.stdout))


def check_flags(text):
    """Commands that are only shown have the flags they are shown with."""
    for line in text.replace("\\\n", " ").splitlines():
        for command, module in HELP.items():
            if f"{command} " in line:
                assert set(re.findall(r"--[a-z-]+", line)) <= flags_of(module), line


@pytest.mark.slow
@pytest.mark.parametrize("page", [page for page in PAGES if list(blocks_of(page))])
def test_the_commands_of_a_page_run(page, scratch):
    blocks = list(blocks_of(page))
    if any("make " in block.code for block in blocks) and not shutil.which("make"):
        pytest.skip("there is no make here")
    if any(block.how == RENDERS for block in blocks):
        try:
            start()
        except MissingRendererError:
            blocks = [block for block in blocks if block.how != RENDERS]
    for prepare in PREPARED.get(page, ()):
        prepare(scratch)
    outputs = run(page, blocks, scratch)
    for block, output in zip(blocks, outputs, strict=True):
        said = iter(output.splitlines())
        for line in block.printed:
            pattern = re.escape(line).replace(r"\.\.\.", ".*")
            assert any(re.fullmatch(pattern, found) for found in said), f"{line}: not in\n{output}"
        if block.how == DRY_RUN:
            check_flags(output)


@pytest.mark.slow
@pytest.mark.parametrize("page", PAGES)
def test_what_is_not_run_says_why(page):
    for block in blocks_of(page):
        assert block.how in (RUN, DRY_RUN, RENDERS, *NOT_RUN), block
        if block.how == DRY_RUN:
            lines = block.code.splitlines()
            assert all(line.startswith(("make ", "#")) for line in lines), block
        if block.how in NOT_RUN:
            check_flags(block.code)


@pytest.mark.parametrize("page", PAGES)
def test_fences_are_of_languages_that_are_looked_at(page):
    for fence in tokens_of(page, "fence"):
        assert fence.info.split()[0] in LANGUAGES + NO_COMMANDS, fence.content


@pytest.mark.slow
@pytest.mark.parametrize("page", PAGES)
def test_commands_within_a_text_have_the_targets_and_flags_they_name(page):
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    for code in tokens_of(page, "code_inline"):
        if target := re.match("make ([a-z-]+)", code.content):
            assert re.search(rf"^{target[1]}:", makefile, re.MULTILINE), code.content
        check_flags(code.content)


def test_every_reason_for_not_running_is_in_use():
    found = {block.how for page in PAGES for block in blocks_of(page)}
    assert found == {RUN, DRY_RUN, RENDERS, *NOT_RUN}


def test_every_flag_on_the_page_on_ebsynth_is_there():
    page = (ROOT / "docs/how_to/from_ebsynth.md").read_text(encoding="utf-8")
    assert set(re.findall(r"`(--[a-z-]+)", page)) <= flags_of("stylit_ref.cli run")
    assert set(re.findall(r"^\| `-([a-z0-9]+)", page, re.MULTILINE)) == set(EBSYNTH)


def test_a_port_is_told_every_stage_in_order():
    page = (ROOT / "docs/how_to/writing_a_port.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| ([a-z_, ]+) \|", page.partition("## In which order")[2], re.MULTILINE)
    assert tuple(", ".join(rows[1:]).split(", ")) == tuple(STYLIZATION.sections)


def test_weights_on_the_page_on_ebsynth_are_equal():
    page = (ROOT / "docs/how_to/from_ebsynth.md").read_text(encoding="utf-8")
    theirs = [float(weight) for weight in re.findall(r"\.png -weight ([\d.]+)", page)]
    ours = [float(weight) for weight in re.findall(r"\.png --weight ([\d.]+)", page)]
    packing = make_packing((3,) * len(ours), 3, Params().guide_influence, ours)
    weights = [int(packing.weights[first]) for first in packing.guide_channels]
    assert weights == [round(ONE * weight / 3) for weight in theirs]
