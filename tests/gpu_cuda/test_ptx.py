"""The list of kernels that are compiled without a GPU."""

import ast
from pathlib import Path

import gpu_cuda
from gpu_cuda.host.ptx import kernels


def test_every_kernel_is_compiled():
    files = Path(gpu_cuda.__file__).parent.rglob("*.py")
    written = {
        node.name
        for file in files
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
        if isinstance(node, ast.FunctionDef)
        and node.name.endswith("_kernel")
        and not node.name.startswith("make_")
    }
    listed = {getattr(kernel, "fn", kernel).__name__ for _, kernel, _ in kernels((32, 8))}
    assert len(written) > 15
    assert listed == written
