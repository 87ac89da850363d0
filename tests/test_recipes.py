"""How many files it takes to add a parameter, a method, a pass or a command: tried on a copy.

Only existing files that must be edited count, not the new file and its test.
"""

import re

import pytest
from code_copy import CodeCopy

pytestmark = pytest.mark.slow

RUN = """
from small_scene import small_scene
from stylit_ref import Params, stylize
def run(**values):
    small = {"levels": 1, "votes": 2, "patchmatch_iterations": 1} | values
    return stylize(*small_scene(), Params(**small))
"""


@pytest.fixture
def code(tmp_path):
    """A copy of the code, with the tests that show whether the recipe is complete."""
    return CodeCopy(tmp_path, ("stylit_ref", "gpu_cuda", "tests"))


def paths(code):
    """Where tests find their helpers."""
    return {"PYTHONPATH": f"{code.folder}:{code.folder / 'tests'}"}


def test_a_parameter(code):
    """It takes the field, with kind and text, and the code that uses it; the option follows."""
    code.edit(
        "stylit_ref/stylization/params.py",
        "    uniformity: float = parameter(",
        "    first_iterations: int = parameter(\n"
        '        0, Integer(0, 9), "PatchMatch iterations more after the first vote"\n'
        "    )\n"
        "    uniformity: float = parameter(",
    )
    code.edit(
        "stylit_ref/stylization/schedules.py",
        "    for iteration in range(1, params.patchmatch_iterations + 1):",
        "    more = params.first_iterations if vote == 1 else 0\n"
        "    for iteration in range(1, params.patchmatch_iterations + more + 1):",
    )
    assert len(code.edited) <= 3
    program = f"{RUN}print(len(run().history), len(run(first_iterations=2).history))"
    assert code.python("-c", program, **paths(code)) == "2 4\n"
    run = "-m", "stylit_ref.cli", "run"
    assert "--first-iterations" in code.python(*run, "--help")
    images = "--style", "a.png", "--guide", "b.png", "c.png", "--output", "d.png"
    refused = code.try_python(*run, *images, "--first-iterations", "10")
    assert refused.returncode == 2
    assert refused.stderr == (
        "stylit-ref: --first-iterations is 10; it must be an integer from 0 to 9\n"
    )


GREEDY = '''"""One PatchMatch iteration after each vote, whatever was asked for."""

from stylit_ref.stylization.progress import SearchStep


def search(level, params, iterate, seed, level_number, vote):
    """One iteration."""
    iterate(level, seed, level_number, vote, 1)
    yield SearchStep(1, level.take_moves(), 1.0)
'''


def test_a_method(code):
    """It takes a file with its search, and a row of the table."""
    code.add("stylit_ref/stylization/greedy.py", GREEDY)
    methods = "stylit_ref/stylization/methods.py"
    code.edit(methods, "import schedules, stylit", "import greedy, schedules, stylit")
    code.edit(
        methods,
        '        Method(\n            "guide_map",',
        '        Method("greedy", "in haste", greedy.search, heeds=("uniformity",)),\n'
        '        Method(\n            "guide_map",',
    )
    assert len(code.edited) <= 2
    program = f"{RUN}print(len(run(method='greedy', patchmatch_iterations=5).history))"
    assert code.python("-c", program, **paths(code)) == "2\n"
    images = "--style", "a.png", "--guide", "b.png", "c.png", "--output", "d.png"
    refused = code.try_python(
        *("-m", "stylit_ref.cli", "run"), *images, "--method", "greedy", "--epsilon", "3"
    )
    assert "--epsilon is for --method guide_map; the method is greedy" in refused.stderr


PASS = '''"""An image turned into its negative."""

from numba import prange

from stylit_ref.machine.kernel import kernel


@kernel()
def negative(image, made):
    """Take every value from 255.

    Parameters
    ----------
    image, made : (H, W, C) uint8
    """
    for y in prange(image.shape[0]):
        for x in range(image.shape[1]):
            for c in range(image.shape[2]):
                made[y, x, c] = 255 - image[y, x, c]
'''

GPU_PASS = '''"""An image turned into its negative."""

from numba import cuda

from gpu_cuda.host.argument_types import IMAGE
from gpu_cuda.host.device import launch


@cuda.jit
def negative_kernel(image, made):
    x, y = cuda.grid(2)
    if y < image.shape[0] and x < image.shape[1]:
        for c in range(image.shape[2]):
            made[y, x, c] = 255 - image[y, x, c]


def kernels(sizes):
    """Every kernel's name, the kernel and the types of its arguments."""
    yield "negative", negative_kernel, (IMAGE, IMAGE)


def negative(image, made):
    """As :func:`stylit_ref.passes.negative`, on device arrays."""
    launch(negative_kernel, image.shape[:2], image, made)
'''

COMPARED = """
import numpy as np
import gpu_cuda
from stylit_ref import passes
image = np.arange(60, dtype=np.uint8).reshape(4, 5, 3)
made = np.zeros_like(image)
passes.negative(image, made)
device = gpu_cuda.upload(np.zeros_like(image))
gpu_cuda.negative(gpu_cuda.upload(image), device)
print(made[0, 0], (gpu_cuda.download(device) == made).all())
"""


def test_a_pass(code):
    """It takes a file for the CPU and one for a GPU, its name in both lists, and its pin."""
    code.add("stylit_ref/passes/negative.py", PASS)
    code.add("gpu_cuda/passes/negative.py", GPU_PASS)
    for module, package in (
        ("stylit_ref.passes", "stylit_ref/passes"),
        ("gpu_cuda.passes", "gpu_cuda"),
    ):
        file = f"{package}/__init__.py"
        anchor = f"from {module}.propagation import propagation\n"
        code.edit(file, anchor, f"from {module}.negative import negative\n{anchor}")
        code.edit(file, '    "moments_storage",\n', '    "moments_storage",\n    "negative",\n')
    before = "occurrence_map(nnf, omega, omega_sums, patch_width)\n"
    code.edit("tests/passes/test_interface.py", before, f"negative(image, made)\n{before}")
    assert len(code.edited) <= 3
    simulated = {"NUMBA_ENABLE_CUDASIM": "1"}
    assert code.python("-c", COMPARED, **simulated) == "[255 254 253] True\n"
    checks = (
        "tests/passes/test_interface.py",
        "tests/gpu_cuda/test_passes.py",
        "tests/gpu_cuda/test_ptx.py",
        "-k",
        "called or mirror or compiled",
    )
    said = code.python("-m", "pytest", "-p", "no:cacheprovider", *checks, **simulated)
    offered = code.python("-c", "import gpu_cuda; print(len(gpu_cuda.__all__))", **simulated)
    # The names, the kernels and the pins once each, and every signature.
    assert re.search(rf" {3 + int(offered)} passed, \d+ deselected in", said), said
