"""Fixtures of several tests."""

import os
import signal
from pathlib import Path

import pytest

from stylit_ref.machine.threads import sleep_while_waiting

pytest_plugins = "hostile.count"


def pytest_configure():
    """Ctrl-C is ignored in the background, and by all that is started from there."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
    sleep_while_waiting()


@pytest.fixture(scope="session")
def golem():
    """The folder of the real scene, beside the checkout or where STYLIT_GOLEM says."""
    default = Path(__file__).parents[2] / "shared" / "data" / "stylit_golem"
    folder = Path(os.environ.get("STYLIT_GOLEM", default))
    if not folder.is_dir():
        pytest.skip("the golem scene is not here (set STYLIT_GOLEM to its folder)")
    return folder
