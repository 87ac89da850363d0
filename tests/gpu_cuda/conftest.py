import sys
from pathlib import Path

import pytest
from numba import config, cuda

sys.path.append(str(Path(__file__).parent))


def pytest_collection_modifyitems(items):
    if not config.ENABLE_CUDASIM and not cuda.is_available():
        reason = "neither a GPU nor Numba's simulator (make test-cuda sets NUMBA_ENABLE_CUDASIM=1)"
        for item in items:
            if Path(__file__).parent in item.path.parents:
                item.add_marker(pytest.mark.skip(reason=reason))
