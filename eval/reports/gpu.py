"""Compare the CUDA kernels with the CPU, byte for byte, and time them on this machine's GPU.

For a machine without OpenImageIO, write a scene to a file with --pack on another machine, and
give that file as SCENE.
"""

import json
import re
import statistics
import time
from pathlib import Path

import numpy as np
from tqdm import tqdm

import gpu_cuda
from eval.pages import options as shared
from eval.pages.gpu_records import record_files
from eval.pages.page import write_record
from eval.provenance import provenance
from gpu_cuda.host import doctor
from gpu_cuda.host.device import kernel_times
from gpu_cuda.variants import launched_commit, live, shared_memory
from stylit_ref import Params
from stylit_ref.files.disk.whole_file import write_text
from stylit_ref.stylization.backends import Backend
from stylit_ref.stylization.problem import make_synthesis

UNIFORMITIES = (0, 5000, 10000)
RUNS = 3
SEARCH = (
    "propagation_kernel",
    "random_search_kernel",
    "commit_kernel",
    "decide_kernel",
    "follow_kernel",
)
"""The kernels of GPU_PatchMatch. Runs of a live schedule also recount Ω and evaluate δ after every
iteration, for the history; the thesis' program does not."""


SETTINGS = (
    {
        f"{name}, λ = {uniformity}": (Params(uniformity=uniformity), backend)
        for uniformity in UNIFORMITIES
        for name, backend in (
            ("propose_commit", Backend(gpu_cuda)),
            ("live", Backend(gpu_cuda, live.live)),
            ("live with W", Backend(gpu_cuda, live.live_sums)),
            ("shared memory", Backend(shared_memory.passes)),
        )
    }
    | {"guide_map, ε = 100": (Params("guide_map", epsilon=100.0), Backend(gpu_cuda))}
    | {"a launch for each step of a commit": (Params(), Backend(launched_commit.passes))}
    | {
        f"blocks of {columns}x{rows}{', shared memory' * shared}": (
            Params(),
            Backend(shared_memory.in_blocks((columns, rows), shared)),
        )
        for columns, rows in ((16, 16), (32, 32))
        for shared in (False, True)
    }
)
"""Params and backend of every whole run; a name without λ stands for the default λ."""


def record(style, source_guides, target_guides, settings):
    """Compare with the CPU and time every setting and every kernel.

    Parameters
    ----------
    style : (H_A, W_A, n) uint8
    source_guides, target_guides : sequence of (H, W, c) uint8
    settings : dict
        As :data:`SETTINGS`.

    Yields
    ------
    dict
        The record so far, after each setting. ``seconds`` is the time of a whole run from host to
        host, ``kernels [s]`` that of each kernel, ``search [s]`` the sum over GPU_PatchMatch's.
    """
    scene = style, source_guides, target_guides
    height, width = target_guides[0].shape[:2]
    parts = "identical to the CPU", "seconds", "search [s]", "energy", "kernels [s]"
    found = {"size": f"{width}x{height}"} | {part: {} for part in parts}
    on_cpu = {}
    for name, (params, backend) in tqdm(settings.items(), unit="setting", disable=None):
        seconds = []
        for _ in range(1 + RUNS):  # the first compiles
            start = time.perf_counter()
            level = make_synthesis(*scene, params, backend=backend).finish()
            nnf, image = backend.passes.download(level.nnf), level.style
            seconds.append(time.perf_counter() - start)
        found["seconds"][name] = statistics.median(seconds[1:])
        level.init_occurrence_map()
        found["energy"][name] = level.energy()
        if backend.iterate is None:
            if params not in on_cpu:
                on_cpu[params] = make_synthesis(*scene, params).finish()
            found["identical to the CPU"][name] = bool(
                (nnf == on_cpu[params].nnf).all()
                and (image == on_cpu[params].style).all()
                and (backend.passes.download(level.omega) == on_cpu[params].omega).all()
            )
        with kernel_times() as times:
            make_synthesis(*scene, params, backend=backend).finish()
        found["kernels [s]"][name] = {
            kernel: {"seconds": sum(seconds), "launches": len(seconds)}
            for kernel, seconds in times.items()
        }
        found["search [s]"][name] = sum(sum(times[kernel]) for kernel in SEARCH if kernel in times)
        yield found


def read_scene(name):
    """Name, style, source guides and target guides of a packed file or of a scene.

    ``DATA:TARGET/STYLE`` is a scene of another data set than the bundled one.
    """
    if Path(name).suffix == ".npz":
        with np.load(name) as file:
            count = sum(key.startswith("source_") for key in file)
            guides = ([file[f"{side}_{k}"] for k in range(count)] for side in ("source", "target"))
            return str(file["scene"]), file["style"], *guides
    from eval.scenes import BUNDLED, load_scene  # needs OpenImageIO

    data, _, name = name.rpartition(":")
    scene = load_scene(name, data or BUNDLED)
    return name, scene.style, scene.source_guides, scene.target_guides


def add_options(parser):
    """Declare what the report may be told."""
    parser.add_argument(
        "scenes", nargs="*", default=["golem/oil"], metavar="SCENE",
        help="TARGET/STYLE (default golem/oil), FOLDER:TARGET/STYLE of another data set, or a "
        "file written by --pack",
    )  # fmt: skip
    parser.add_argument(
        "--pack", type=Path, metavar="FILE.npz", help="only write the first scene to this file"
    )
    shared.add_output(parser, "gpu")


def main(options, settings=SETTINGS):
    """Write the record, or pack a scene; returns the exit code."""
    scenes = [read_scene(name) for name in options.scenes]
    if options.pack:
        pack(options.pack, *scenes[0])
        return 0
    missing = doctor.missing()
    if missing:
        print(f"skipped: {missing}")
        return 0
    device = re.sub(r"\W+", "_", doctor.device_name()).strip("_")
    folder = shared.folder_of(options, "gpu")
    folder.mkdir(parents=True, exist_ok=True)
    result = {"circumstances": provenance(), "device": doctor.report(), "scenes": []}
    for name, *images in scenes:
        result["scenes"].append({})
        for found in record(*images, settings):
            result["scenes"][-1] = {"scene": name} | found
            text = json.dumps(result, indent=1, ensure_ascii=False)
            write_text(folder / f"{device}.json", text + "\n")
    files = [file.name for file in record_files(folder)]
    write_record(folder, files, files)
    print(text)
    same = [same for scene in result["scenes"] for same in scene["identical to the CPU"].values()]
    return 0 if all(same) else 1


def pack(file, name, style, source_guides, target_guides):
    """Write a scene to a file that :func:`read_scene` reads."""
    guides = {
        f"{side}_{k}": guide
        for side, images in (("source", source_guides), ("target", target_guides))
        for k, guide in enumerate(images)
    }
    np.savez_compressed(file, scene=name, style=style, **guides)
