"""Processes that a test has started."""

import time
from pathlib import Path


def ends(process):
    """Whether a killed process ends soon; a zombie counts as ended."""
    for _ in range(50):
        try:
            state = Path(f"/proc/{process}/stat").read_text(encoding="utf-8")
        except (FileNotFoundError, ProcessLookupError):
            return True
        if state.rpartition(")")[2].split()[0] == "Z":
            return True
        time.sleep(0.1)
    return False
