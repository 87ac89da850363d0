"""``stylit-ref doctor``: what this installation has, and what it lacks."""

import argparse
import os
import platform
from importlib.metadata import version
from pathlib import Path

import numba
import OpenImageIO as oiio

from stylit_ref import __version__
from stylit_ref.cli.methods import OFFERS, made_params
from stylit_ref.cli.parser import Parser
from stylit_ref.stylization.warm_up import SIX_GUIDES
from stylit_ref.texture.warm_up import kernels_of_all_textures


def add_parser(commands: "argparse._SubParsersAction[Parser]") -> None:
    """Add the command."""
    parser = commands.add_parser(
        "doctor",
        help="say what this installation has: threads, compiled kernels, file kinds, GPU",
        description="Say what this installation has: versions, threads, where compiled kernels are "
        "kept and\nwhich are there, which image files it reads and writes, and what there is for a "
        "GPU.",
    )
    parser.set_defaults(command=run, parser=parser)


def run(_: argparse.Namespace) -> None:
    """Print the report; a missing part is what it is about, not an error."""
    for name, text in _lines():
        print(f"{name:13} {text}")
    try:
        from gpu_cuda.host.doctor import report
    except ImportError as error:  # of numba-cuda, where a part of it is not installed
        print(f"GPU           none: the kernels cannot be loaded: {error}")
    else:
        print(*report(), sep="\n")


def _lines():
    yield "stylit-ref", f"{__version__}, Python {platform.python_version()}"
    yield "OpenImageIO", version("OpenImageIO")
    threads = numba.config.NUMBA_NUM_THREADS
    yield "threads", f"{threads} of {os.cpu_count()}; NUMBA_NUM_THREADS sets another number"
    yield from _kernel_lines()
    yield "reads", _kinds("input_format_list", without=("null",))
    yield "writes", _kinds("output_format_list", without=("null", "term", "gif"))


def _kernel_lines():
    needed = {
        name: offer.kernels(made_params(name, next(iter(offer.presets.values()))), 3, SIX_GUIDES)
        for name, offer in OFFERS.items()
    }
    needed["textures"] = kernels_of_all_textures()
    folders = {each.folder for kernels in needed.values() for each in kernels}
    if None in folders:
        yield (
            "kernels",
            "no folder can be written, so every run compiles; set NUMBA_CACHE_DIR to one that can",
        )
    else:
        files = [file for folder in folders for file in folder.glob("*.nb?")]
        size = sum(file.stat().st_size for file in files) / 2**20
        place, named = os.path.commonpath(folders), numba.config.CACHE_DIR
        remark = "NUMBA_CACHE_DIR sets another folder"
        if named and not Path(place).is_relative_to(Path(named).resolve()):
            remark = f"NUMBA_CACHE_DIR names {named}, which cannot be written"
        yield "kernels", f"{size:.1f} MiB in {place}; {remark}"
    counts = [
        f"{sum(each.is_compiled for each in kernels)} of {len(kernels)} for {name}"
        for name, kernels in needed.items()
    ]
    text = f"{', '.join(counts)}; pictures with six guides in colour. A run compiles what it lacks"
    yield "compiled", text


def _kinds(attribute, without):
    names = oiio.get_string_attribute(attribute).split(",")
    return ", ".join(name for name in names if name not in without)
