"""What GPUs did, from the records in ``reports/gpu`` and, before them, ``build/reports/gpu``."""

import json

from eval.pages.page import BUILT, COMMITTED, RECORD


def gpu_records(scene, size):
    """Records of a scene.

    Parameters
    ----------
    scene : str
        TARGET/STYLE.
    size : str
        As ``300x228``.

    Returns
    -------
    dict of str to dict
        By device; as :func:`eval.reports.gpu.record` makes them.
    """
    found = {}
    for file in record_files(COMMITTED / "gpu") + record_files(BUILT / "gpu"):
        for record in json.loads(file.read_text(encoding="utf-8"))["scenes"]:
            if record["scene"] == scene and record["size"] == size:
                found[file.stem] = record
    return found


def record_files(folder):
    """The records in a folder, one of each device."""
    return sorted(file for file in folder.glob("*.json") if file.name != RECORD)
