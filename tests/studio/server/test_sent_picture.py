"""What has changed between two pictures is all that a page needs of the second."""

import struct

import numpy as np
import pytest
from studio.server.opened import in_loop
from studio.whole_picture import image_of, whole_picture

from stylit_ref.studio.engine.events import Picture
from stylit_ref.studio.server.outbox import Outbox
from stylit_ref.studio.server.protocol import PICTURES
from stylit_ref.studio.server.sent_picture import SentPicture

SIZES = (1, 1), (16, 32), (17, 33), (50, 41), (15, 100)


def picture(size, seed=0):
    image = np.random.default_rng(seed).integers(0, 256, (*size, 3), np.uint8)
    return SentPicture(Picture("replay", image, 7, 1.5))


def painted(before, seed=1):
    """The same picture with a few pixels of other colours, its last one among them."""
    rng = np.random.default_rng(seed)
    image = before.picture.image.copy()
    height, width = image.shape[:2]
    for _ in range(3):
        image[rng.integers(height), rng.integers(width), rng.integers(3)] ^= 1
    image[-1, -1] ^= 255
    return SentPicture(Picture("coherent", image, 8, 2.5))


def shown(message, before):
    """What a page makes of it that has the picture ``before``."""
    message = whole_picture(message, before and before.message(None))
    assert struct.unpack_from("<BBHHHIf", message)[1::4] == (PICTURES.index("coherent"), 8)
    return image_of(message)


@pytest.mark.parametrize("size", SIZES)
def test_the_changes_of_a_picture_make_it(size):
    before = picture(size)
    after = painted(before)
    np.testing.assert_array_equal(shown(after.message(before), before), after.picture.image)


def test_a_stroke_is_a_small_message():
    before = picture((500, 500))
    image = before.picture.image.copy()
    image[100:130, 200:240] = 0
    message = SentPicture(Picture("coherent", image, 8, 2.5)).message(before)
    np.testing.assert_array_equal(shown(message, before), image)
    assert len(message) < 20_000


def test_an_equal_picture_has_no_tiles():
    before = picture((50, 41))
    again = SentPicture(Picture("coherent", before.picture.image.copy(), 8, 2.5))
    assert len(again.message(before)) == 16 + 2


@pytest.mark.parametrize(
    "before", [None, picture((51, 41)), picture((50, 41), 3)], ids=["none", "size", "all"]
)
def test_what_has_little_to_do_with_the_one_before_is_sent_whole(before):
    after = painted(picture((50, 41)))
    message = after.message(before)
    assert message[0] == 1
    np.testing.assert_array_equal(shown(message, None), after.picture.image)


@in_loop
async def test_changes_are_those_since_what_was_sent():
    first = picture((50, 41))
    second = painted(first)
    third = painted(second, 2)
    outbox = Outbox()
    outbox.show("picture", first)
    await outbox.next()
    outbox.show("picture", second)  # is never sent
    outbox.show("picture", third)
    message = await outbox.next()
    np.testing.assert_array_equal(shown(message, first), third.picture.image)
