"""What is painted on, and what follows: named buffers of a source and of a turning target."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from stylit_ref.errors import InputError
from stylit_ref.files.guides.encoding import GuideEncoding

Buffers = Mapping[str, NDArray[np.uint8]]

LARGEST_SIDE = 4096
"""Most pixels along a side of the painting, and of a target."""


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
        By buffer; the size is that of the painting.
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
        If there is no buffer or no step, buffers differ in size, or a side is too long.
    """

    name: str
    title: str
    source: Buffers
    targets: Sequence[Callable[[], Buffers]]
    files: SceneFiles | None = None
    encodings: tuple[GuideEncoding, ...] = ()
    layers: tuple[str, ...] = ()
    _read: dict[int, Buffers] = field(default_factory=dict, init=False, repr=False)

    def __post_init__(self) -> None:
        if not self.source or not self.targets:
            raise InputError(f"the scene {self.name} needs a buffer and a target")
        _check_sizes(self.source, f"the source of {self.name}")

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
        """Buffers of a step, by name; those of the last one are kept.

        Raises
        ------
        InputError
            If there is no such step, or its buffers are not those of the source.
        """
        if not 0 <= step < self.steps:
            raise InputError(f"is {step}; it must be from 0 to {self.steps - 1}", parameter="step")
        if step not in self._read:
            buffers = self.targets[step]()
            _check_sizes(buffers, f"step {step} of {self.name}")
            kinds = ({name: image.shape[2:] for name, image in side.items()}
                     for side in (self.source, buffers))  # fmt: skip
            own, found = kinds
            if own != found:
                raise InputError(
                    f"step {step} of {self.name} has other buffers or channels than the source; "
                    "render both with the same passes"
                )
            self._read.clear()
            self._read[step] = buffers
        return self._read[step]


def _check_sizes(buffers: Buffers, whose: str) -> None:
    sizes = {image.shape[:2] for image in buffers.values()}
    if len(sizes) != 1:
        raise InputError(f"{whose} has buffers of several sizes; make them as large as each other")
    height, width = sizes.pop()
    if max(height, width) > LARGEST_SIDE:
        raise InputError(
            f"{whose} is {width}x{height}; each side must be at most {LARGEST_SIDE} pixels in the "
            "studio; make it smaller"
        )
