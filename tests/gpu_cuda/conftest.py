import sys
from pathlib import Path

import pytest

from gpu_cuda.host import doctor

sys.path.append(str(Path(__file__).parent))


def pytest_collection_modifyitems(items):
    missing = doctor.missing()
    if missing:
        reason = f"{missing}; make test runs these in Numba's simulator (NUMBA_ENABLE_CUDASIM=1)"
        for item in items:
            if Path(__file__).parent in item.path.parents:
                item.add_marker(pytest.mark.skip(reason=reason))
