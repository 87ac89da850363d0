"""A copy of the project's code that a test may edit and run."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

CHECKOUT = Path(__file__).parents[1]
PACKAGES = "stylit_ref", "gpu_cuda", "eval", "data_gen", "oracle"


class CodeCopy:
    """Packages of the project in a folder of their own.

    Attributes
    ----------
    folder : Path
    edited : set of str
        Files of the project that :meth:`edit` has changed.
    """

    def __init__(self, folder, packages=PACKAGES):
        self.folder, self.edited = folder, set()
        for package in packages:
            ignored = shutil.ignore_patterns("__pycache__", "bundled", "v1")
            shutil.copytree(CHECKOUT / package, folder / package, ignore=ignored)
        for data in ("data_gen/bundled", "oracle/v1"):
            if (folder / data).parent.exists():
                (folder / data).symlink_to(CHECKOUT / data)

    def edit(self, file, old, new):
        """Replace text that a file has once."""
        text = (self.folder / file).read_text(encoding="utf-8")
        assert text.count(old) == 1, f"{file} has {old!r} {text.count(old)} times"
        (self.folder / file).write_text(text.replace(old, new), encoding="utf-8")
        self.edited.add(file)

    def add(self, file, text):
        """Write a new file."""
        assert not (self.folder / file).exists()
        (self.folder / file).write_text(text, encoding="utf-8")

    def try_python(self, *arguments, **environment):
        """Run Python with the copy; returns the finished process."""
        own = {"PYTHONPATH": str(self.folder), "NUMBA_CACHE_DIR": str(self.folder / "kernels")}
        return subprocess.run(
            [sys.executable, *arguments],
            cwd=self.folder,
            env=os.environ | own | environment,
            capture_output=True,
            text=True,
        )

    def python(self, *arguments, **environment):
        """What Python with the copy says; it must succeed."""
        done = self.try_python(*arguments, **environment)
        assert done.returncode == 0, done.stderr
        return done.stdout
