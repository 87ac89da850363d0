"""From render buffers to the few bytes of a pixel that the search compares.

Three packings: :class:`StagePacking`, what Heidrich's Figure 16 keeps of a red object on a white
stage; :class:`UnpackedStage`, all of it; and :class:`PrincipalPacking`, the principal components of
any other scene. Each has

- ``names``: the buffers that it reads, all of them required;
- ``channels``: for each byte of a pixel the name of its buffer, by which it is weighted;
- ``pack_into(buffers, out, labels=None)``: writes a frame's bytes, and its labels if they are asked
  for, and allocates no image.

A buffer is (H, W) or (H, W, 3) uint8. A label is a number for each kind of thing; paint must not go
from one to another.
"""

from stylit_ref.realtime.packing.choose import choose_packing
from stylit_ref.realtime.packing.packed import Packing, pack
from stylit_ref.realtime.packing.principal import PrincipalPacking
from stylit_ref.realtime.packing.stage import StagePacking
from stylit_ref.realtime.packing.unpacked import UnpackedStage

__all__ = ["Packing", "PrincipalPacking", "StagePacking", "UnpackedStage", "choose_packing", "pack"]
