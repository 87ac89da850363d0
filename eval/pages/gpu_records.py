"""Records of GPUs, in ``reports/gpu`` and, preferably, in ``build/reports/gpu``."""

import json

from eval.pages.page import BUILT, COMMITTED, RECORD


def gpu_records(scene, size):
    """Records of a scene.

    Parameters
    ----------
    scene : str
        TARGET/STYLE.
    size : str
        Such as ``300x228``.

    Returns
    -------
    dict of str to dict
        By device; made by :func:`eval.reports.gpu.record`.
    """
    found = {}
    for file in record_files(COMMITTED / "gpu") + record_files(BUILT / "gpu"):
        for record in json.loads(file.read_text(encoding="utf-8"))["scenes"]:
            if record["scene"] == scene and record["size"] == size:
                found[file.stem] = record
    return found


def record_files(folder):
    """The record files in a folder, one for each device."""
    return sorted(file for file in folder.glob("*.json") if file.name != RECORD)
