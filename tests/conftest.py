"""Fixtures of several tests."""

import os
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def golem():
    """The folder of the real scene, beside the checkout or where STYLIT_GOLEM says."""
    default = Path(__file__).parents[2] / "shared" / "data" / "stylit_golem"
    folder = Path(os.environ.get("STYLIT_GOLEM", default))
    if not folder.is_dir():
        pytest.skip("the golem scene is not here (set STYLIT_GOLEM to its folder)")
    return folder
