"""How pixels lie in memory for certain parameters and a number of guides."""

from dataclasses import dataclass

from stylit_ref.machine.replaced import Passes
from stylit_ref.machine.vector_patch import STYLE_LANES, cell_bytes
from stylit_ref.realtime.formulae.average import box_radius
from stylit_ref.realtime.formulae.grid import level_size
from stylit_ref.realtime.params import RealtimeParams
from stylit_ref.realtime.passes.image import Image


@dataclass(frozen=True)
class Layout:
    """Sizes that follow from the parameters.

    Attributes
    ----------
    params : RealtimeParams
    channels : int
        Of the guides.
    passes : module
        :mod:`stylit_ref.realtime.passes`, or such passes with some replaced.
    """

    params: RealtimeParams
    channels: int
    passes: Passes

    @property
    def lanes(self) -> int:
        """Bytes of a pixel of the guides, with room for the style."""
        return -(-self.channels // 4) * 4 + STYLE_LANES

    @property
    def margin(self) -> int:
        """How far a patch reaches from its centre; centres lie as far from the source's edge."""
        return self.params.patch_width // 2

    @property
    def border(self) -> int:
        """Pixels around every image, for patches, boxes and vectors that reach beyond it."""
        params = self.params
        boxes = params.scale_space and params.means == "box"
        return max(
            self.margin + 1,
            cell_bytes(params.step) // STYLE_LANES,
            box_radius(params.depth - 1) if boxes else 0,
        )

    @property
    def patch_shape(self) -> tuple[int, int]:
        """Rows and pixels of what the search compares; records are patches of one row."""
        params = self.params
        return (1, params.depth) if params.scale_space else (params.patch_width,) * 2

    @property
    def images(self) -> int:
        """Levels of an image, those for texels of the coarsest level included."""
        params = self.params
        mips = params.scale_space and params.means == "mip"
        return params.levels + (params.depth - 1 if mips else 0)

    def sizes(self, height: int, width: int) -> list[tuple[int, int]]:
        """Height and width of every level."""
        return [(level_size(height, k), level_size(width, k)) for k in range(self.images)]

    def lanes_read(self, level: int) -> int:
        """Bytes of a pixel that the search of a level reads."""
        return self.lanes if self.params.reads_guides(level) else STYLE_LANES

    def unit(self, level: int) -> int:
        """Bytes of a record that the search of a level reads."""
        return self.lanes_read(level) * self.params.depth

    def make_records(
        self, images: list[Image], level: int, step: int, records: Image, lanes: int
    ) -> None:
        """Fill the records of every ``step``-th pixel of a level, from ``lanes`` bytes each."""
        depth = self.params.depth
        if self.params.means == "box":
            self.passes.make_box_records(lanes, depth)(images[level], step, records)
        else:
            for scale in range(depth):
                self.passes.make_mip_records(lanes, depth)(
                    images[level + scale], scale, step, records
                )
