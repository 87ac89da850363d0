"""A layer of a large file takes the memory of that layer."""

import subprocess
import sys

import numpy as np
import OpenImageIO as oiio
import pytest

READER = """
import resource, sys
import numpy as np
from stylit_ref import read_uint8

def peak():
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss

before = peak()
image = read_uint8(sys.argv[1])
print(image.shape == (1024, 1024, 4), (peak() - before) // 1024)
"""


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="the unit of ru_maxrss is the system's own")
def test_one_layer_of_many(tmp_path):
    file = tmp_path / "a.exr"
    spec = oiio.ImageSpec(1024, 1024, 68, "half")
    spec.channelnames = tuple(f"Pass{k:02}.{c}" for k in range(17) for c in "RGBA")
    output = oiio.ImageOutput.create(str(file))
    assert output.open(str(file), spec)
    for y in range(0, 1024, 16):
        assert output.write_scanlines(y, y + 16, 0, np.full((16, 1024, 68), 0.25, np.float16))
    output.close()
    command = [sys.executable, "-c", READER, f"{file}:Pass09"]
    right, megabytes = subprocess.run(command, check=True, capture_output=True).stdout.split()
    assert right == b"True"
    assert int(megabytes) < 80  # 16 as floating point; the whole file takes 272
