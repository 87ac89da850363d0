"""What is painted on, and what follows: named buffers of a source and of a turning target."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from threading import Lock

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.guides.encoding import GuideEncoding
from stylit_ref.parameters import Integer
from stylit_ref.realtime.packing.named_buffers import roles_of

Buffers = Mapping[str, NDArray[np.uint8]]

LARGEST_SIDE = 4096
"""Most pixels along a side of the painting, and of a target."""

_MOST_KEPT = 256 << 20
"""Bytes of the steps of a target that are kept once they are read."""


@dataclass(frozen=True)
class SceneFiles:
    """Where buffers were read from, in the order of a scene's buffers.

    Attributes
    ----------
    source : tuple of str
        As the user gave them; a layer may follow a colon.
    targets : tuple of tuple of str
        Of every step.
    """

    source: tuple[str, ...]
    targets: tuple[tuple[str, ...], ...]


@dataclass(frozen=True, eq=False)
class Scene:
    """A source and the steps of a target.

    Attributes
    ----------
    name : str
        For programs; unique.
    title : str
        For people.
    source : mapping of str to (H_A, W_A, n) uint8
        By buffer, called as :func:`~stylit_ref.realtime.packing.named_buffers.roles_of` calls them;
        the size is that of the painting. Without files they have one or three channels.
    targets : sequence of callable
        For each step what reads its buffers, those of the source: (H_B, W_B, n) uint8.
    files : SceneFiles, optional
        None if the scene is in memory alone.
    encodings : tuple of GuideEncoding
        How the values of each buffer became 8 bits; empty where they were 8 bits.
    layers : tuple of str
        Layers to pick from; those of the scene are among them.

    Raises
    ------
    InputError
        If there is no buffer or no step, buffers differ in size, a side is too long, or buffers
        could not be written for an export.
    """

    name: str
    title: str
    source: Buffers
    targets: Sequence[Callable[[], Buffers]]
    files: SceneFiles | None = None
    encodings: tuple[GuideEncoding, ...] = ()
    layers: tuple[str, ...] = ()
    _read: dict[int, Buffers] = field(default_factory=dict, init=False, repr=False)
    _lock: Lock = field(default_factory=Lock, init=False, repr=False)

    def __post_init__(self) -> None:
        if not self.source or not self.targets:
            raise InputError(f"the scene {self.name} needs a buffer and a target")
        _check_sizes(self.source, f"the source of {self.name}")
        if self.files is None:
            self._check_writable()

    @property
    def buffers(self) -> tuple[str, ...]:
        """Their names."""
        return tuple(self.source)

    @property
    def size(self) -> tuple[int, int]:
        """Height and width of the painting."""
        height, width = next(iter(self.source.values())).shape[:2]
        return height, width

    @property
    def steps(self) -> int:
        """How many there are of the target."""
        return len(self.targets)

    def target(self, step: int) -> Buffers:
        """Buffers of a step, by name; those that were read last are kept.

        Raises
        ------
        InputError
            If there is no such step, or its buffers are not those of the source.
        """
        Integer(0, self.steps - 1).check("step", step)
        with self._lock:
            if step not in self._read:
                self._read[step] = self._checked(step, self.targets[step]())
                while len(self._read) > 1 and _bytes_of(self._read) > _MOST_KEPT:
                    del self._read[next(iter(self._read))]
            return self._read[step]

    def _checked(self, step: int, buffers: Buffers) -> Buffers:
        _check_sizes(buffers, f"step {step} of {self.name}")
        if _channels_of(buffers) != _channels_of(self.source):
            raise InputError(
                f"step {step} of {self.name} has other buffers or channels than the source; "
                "render both with the same passes"
            )
        return {name: buffers[name] for name in self.source}  # guides are paired by their order

    def _check_writable(self) -> None:
        if roles_of(self.buffers, ()) != list(self.buffers) or any(
            not name.isidentifier() or image.shape[2] not in (1, 3)
            for name, image in self.source.items()
        ):
            raise InputError(
                f"the source of {self.name} has the buffers {', '.join(self.buffers)}; without "
                "files each needs one or three channels and a name of capitals, as FULL or LDE"
            )


def _channels_of(buffers: Buffers) -> dict[str, int]:
    return {name: image.shape[2] for name, image in buffers.items()}


def _bytes_of(steps: Mapping[int, Buffers]) -> int:
    return sum(image.nbytes for buffers in steps.values() for image in buffers.values())


def _check_sizes(buffers: Buffers, whose: str) -> None:
    if any(image.dtype != np.uint8 or image.ndim != 3 for image in buffers.values()):
        raise InputError(f"{whose} must have buffers of uint8, each (height, width, channels)")
    sizes = {image.shape[:2] for image in buffers.values()}
    if len(sizes) != 1:
        raise InputError(f"{whose} has buffers of several sizes; make them as large as each other")
    height, width = sizes.pop()
    if max(height, width) > LARGEST_SIDE:
        raise InputError(
            f"{whose} is {width}x{height}; each side must be at most {LARGEST_SIDE} pixels in the "
            "studio; make it smaller"
        )
