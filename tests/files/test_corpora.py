"""Every file under a folder of public images is read, or refused in one sentence.

``STYLIT_CORPORA`` names the folder, for instance of openexr-images, OpenImageIO-images and the tests
of image-rs. Damaged files are among them.
"""

import os
import signal
from pathlib import Path

import numpy as np
import pytest

from stylit_ref import InputError, read_image

FOLDER = os.environ.get("STYLIT_CORPORA")
FILES = sorted(file for file in Path(FOLDER or "").rglob("*") if FOLDER and file.is_file())


@pytest.fixture(autouse=True)
def _no_file_hangs():
    def ended(*_):
        raise TimeoutError

    before = signal.signal(signal.SIGALRM, ended)
    signal.alarm(60)
    yield
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


def outcome(file):
    """The image and no sentence, or no image and the sentence of the refusal."""
    try:
        return read_image(file), None
    except InputError as refused:
        return None, str(refused)


@pytest.mark.skipif(not FOLDER, reason="STYLIT_CORPORA names no folder of public images")
@pytest.mark.slow
@pytest.mark.parametrize("file", FILES, ids=lambda file: str(file.relative_to(FOLDER)))
def test_a_public_file_is_read_or_refused_in_one_sentence(file):
    image, sentence = outcome(file)
    if sentence is None:
        assert image.ndim == 3
        assert image.size
        assert image.dtype in (np.uint8, np.uint16, np.float32)
    else:
        assert sentence.startswith(str(file))
        assert "\n" not in sentence
