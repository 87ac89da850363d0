"""Name the machine, the versions and the commit that made a report."""

import platform
import subprocess
from datetime import date
from pathlib import Path

import numba

from eval.device import processor
from stylit_ref import __version__


def provenance():
    """One line with the machine, the versions and the commit of a report."""
    threads = numba.get_num_threads()
    return (
        f"stylit-ref {__version__}, commit {_COMMIT}; {processor()}, "
        f"{threads} thread{'s' if threads > 1 else ''}; Python {platform.python_version()}, "
        f"numba {numba.__version__}; {date.today().isoformat()}"
    )


def _commit():
    """Commit of the checkout; changed reports do not count as changes."""
    try:
        commit = _git("rev-parse", "--short", "HEAD")
        changed = _git("status", "--porcelain", "--untracked-files=no", "--", ".", ":!reports")
    except (OSError, subprocess.CalledProcessError):
        return "unknown"
    return f"{commit} with changes" if changed else commit


def _git(*arguments):
    """Output of a git command in this checkout."""
    checkout = Path(__file__).parents[1]
    command = ["git", "-C", checkout, *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


# Asked at the start: edits and commits during a long report do not belong to its code.
_COMMIT = _commit()
