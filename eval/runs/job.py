"""A run that is to be done, and what its result depends on."""

import hashlib
import json
import re
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import Any

from eval.scenes import Scene

_LETTERS = str.maketrans({"λ": "lambda", "ε": "epsilon"})


@dataclass(frozen=True)
class Job:
    """What a run's result depends on.

    Attributes
    ----------
    scene : Scene
    method : object
        One of :mod:`eval.methods`.
    seed : int
    place : str, optional
        Where it runs, for times are of one device. By default the method's own device here.
    """

    scene: Scene
    method: Any
    seed: int = 0
    place: str | None = None

    @cached_property
    def key(self):
        """Identifies the result."""
        identity = [
            self.scene.digest, type(self.method).__name__, asdict(self.method), self.method.code,
            self.seed, self.place or self.method.device,
        ]  # fmt: skip
        return hashlib.sha256(json.dumps(identity).encode()).hexdigest()[:24]

    @cached_property
    def file_name(self):
        """For people to find it, and a piece of the key to tell it from its like."""
        parts = f"{self.scene.name} {self.scene.size}", self.method.name, f"seed {self.seed}"
        words = (re.sub(r"[^A-Za-z0-9.]+", "_", part.translate(_LETTERS)) for part in parts)
        return "-".join([*words, self.key[:8]])

    @property
    def title(self):
        """For progress and errors."""
        return f"{self.scene.name}, {self.method.name}, seed {self.seed}"

    @property
    def cost(self):
        """In runs of ``ref`` on one pixel."""
        height, width = self.scene.target_guides[0].shape[:2]
        return height * width * self.method.cost
