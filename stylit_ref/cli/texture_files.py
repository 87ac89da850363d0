"""Files that ``texture`` and ``edit-texture`` write."""

import argparse
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from stylit_ref.cli.deep_images import holds_bits_of
from stylit_ref.cli.texture_images import Source
from stylit_ref.files.colour.profile import read_colour_profile
from stylit_ref.files.disk.paths import check_distinct
from stylit_ref.files.texture_field import check_texture_field_writable, write_texture_field
from stylit_ref.files.write_image import check_image_writable, write_image
from stylit_ref.texture.replaying import replay_texture
from stylit_ref.texture.session import TextureSession
from stylit_ref.texture.synthesize import TextureResult

_CHANNELS_OF_OVERLAY = 3


def add_other_files(group: argparse._ArgumentGroup) -> None:
    """Add the options that name files beside the picture."""
    group.add_argument(
        "--save-coordinates", metavar="FILE.npy",
        help="write where every pixel came from, for 'texture --start', 'edit-texture' and "
        "'replay-texture'",
    )  # fmt: skip
    group.add_argument(
        "--save-tiled",
        metavar="IMAGE",
        help="write the texture twice beside and twice below itself, to see how it tiles",
    )
    group.add_argument(
        "--save-overlay", metavar="IMAGE",
        help="write the texture with its seams in red, and the patches of one more iteration: "
        "green where they would be accepted, blue where rejected",
    )  # fmt: skip


class TextureFiles:
    """Files that the options name, which can be written and are none of those that are read.

    Parameters
    ----------
    options : argparse.Namespace
        With ``output``, ``save_coordinates``, ``save_tiled`` and ``save_overlay``.
    sources : sequence of Source
    inputs : sequence of str or None
        What is read; the first is the file of the first source, whose profile the picture gets.

    Raises
    ------
    InputError
    """

    def __init__(
        self, options: argparse.Namespace, sources: Sequence[Source], inputs: Sequence[str | None]
    ) -> None:
        first = sources[0]
        self._options, self._sources = options, sources
        self._profile = read_colour_profile(inputs[0])
        self._is_deep = first.is_deep and holds_bits_of(
            first.pixels, options.output, first.pixels.shape[2], "exemplar"
        )
        channels = (first.pixels if self._is_deep else first.colours).shape[2]
        check_image_writable(options.output, channels)
        if options.save_tiled:
            check_image_writable(options.save_tiled, channels)
        if options.save_overlay:
            check_image_writable(options.save_overlay, _CHANNELS_OF_OVERLAY)
        if options.save_coordinates:
            check_texture_field_writable(options.save_coordinates)
        check_distinct([options.output, *self.others], inputs)

    @property
    def others(self) -> list[str]:
        """What is written beside the picture."""
        options = self._options
        others = options.save_tiled, options.save_coordinates, options.save_overlay
        return [path for path in others if path]

    def picture(
        self, made: TextureResult | TextureSession
    ) -> NDArray[np.uint8 | np.uint16 | np.float32]:
        """The texture, with the depth and alpha of its exemplars where the file can hold them."""
        if not self._is_deep:
            return made.image
        return replay_texture(made.field, [source.pixels for source in self._sources])

    def write(
        self,
        image: NDArray[np.uint8 | np.uint16 | np.float32],
        made: TextureResult | TextureSession,
        overlay: Callable[[], NDArray[np.uint8]] | None,
    ) -> None:
        """Write the picture and what is beside it; ``overlay`` is drawn where it is asked for."""
        options = self._options
        write_image(options.output, image, curve="srgb", profile=self._profile)
        if options.save_tiled:
            tiled = np.tile(image, (2, 2, 1))
            write_image(options.save_tiled, tiled, curve="srgb", profile=self._profile)
        if options.save_coordinates:
            write_texture_field(options.save_coordinates, made.field)
        if options.save_overlay and overlay:
            write_image(options.save_overlay, overlay())
