"""A run to do, and everything that its result depends on."""

import hashlib
import json
import re
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import Any

from eval.scenes import Scene
from eval.textures import Texture

_LETTERS = str.maketrans({"λ": "lambda", "ε": "epsilon"})


@dataclass(frozen=True)
class Job:
    """Everything that the result of a run depends on.

    Attributes
    ----------
    scene : Scene or Texture
    method : object
        One of :mod:`eval.methods`.
    seed : int
    place : str, optional
        Device that it runs on, since times depend on it. By default the method's device here.
    """

    scene: Scene | Texture
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
        """Name of the result's file: readable words, and a part of the key to make it unique."""
        parts = f"{self.scene.name} {self.scene.size}", self.method.name, f"seed {self.seed}"
        words = (re.sub(r"[^A-Za-z0-9.]+", "_", part.translate(_LETTERS)) for part in parts)
        return "-".join([*words, self.key[:8]])

    @property
    def title(self):
        """Name of the run in progress bars and errors."""
        return f"{self.scene.name}, {self.method.name}, seed {self.seed}"

    @property
    def cost(self):
        """Rough time of the run, in units of ``ref`` on one pixel."""
        return self.scene.pixels * self.method.cost
