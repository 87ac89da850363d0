"""Fixtures of several tests."""

import os
import signal
from pathlib import Path

import pytest

from stylit_ref.machine.threads import sleep_while_waiting
from stylit_ref.notes import ONCE


def pytest_configure():
    """Restore Ctrl-C, which background processes and all that they start ignore."""
    signal.signal(signal.SIGINT, signal.default_int_handler)
    sleep_while_waiting()


def foreign_data(name):
    """A folder of images outside the repository; the test is skipped without it."""
    beside_the_checkout = Path(__file__).parents[2] / "shared" / "data"
    folder = Path(os.environ.get("STYLIT_DATA", beside_the_checkout)) / name
    if not folder.is_dir():
        pytest.skip(f"{name} is not here (set STYLIT_DATA to the folder that holds it)")
    return folder


@pytest.fixture(autouse=True)
def _nothing_was_noted():
    """Every test may hear what the ones before it heard."""
    ONCE.said.clear()


@pytest.fixture(scope="session")
def golem():
    """The scene that figures and defaults were measured on."""
    return foreign_data("stylit_golem")
