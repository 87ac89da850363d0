"""What GPUs did, from the records in ``reports/gpu``."""

import json

from eval.report import REPORTS


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
        By device; as :func:`eval.gpu_record.record` makes them.
    """
    found = {}
    for file in sorted((REPORTS / "gpu").glob("*.json")):
        for record in json.loads(file.read_text(encoding="utf-8"))["scenes"]:
            if record["scene"] == scene and record["size"] == size:
                found[file.stem] = record
    return found
