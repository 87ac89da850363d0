"""What a page makes of a message that has only the changes of a picture, pixel by pixel."""

import struct

import numpy as np

HEAD = struct.Struct("<BBHHHIf")
TILE = 16


def image_of(message):
    """The picture or painting of a message that brings all of it, (H, W, 3) uint8."""
    _, _, width, height, name, _, _ = HEAD.unpack_from(message)
    return np.frombuffer(message, np.uint8, offset=HEAD.size + name).reshape(height, width, 3)


def whole_picture(message, before):
    """The message that would have brought all of a picture; ``before`` is the last such."""
    if message[0] == 1:
        return message
    assert message[0] == 3
    _, which, width, height, length, serial, milliseconds = HEAD.unpack_from(message)
    columns, rows = -(-width // TILE), -(-height // TILE)
    name, body = message[HEAD.size :][:length], message[HEAD.size + length :]
    image = image_of(before).copy()
    assert image.shape == (height, width, 3)
    at = -(-rows * columns // 8)
    for tile in range(rows * columns):
        if body[tile // 8] >> tile % 8 & 1:
            for y in range(TILE):
                for x in range(TILE):
                    place = tile // columns * TILE + y, tile % columns * TILE + x
                    if place[0] < height and place[1] < width:
                        image[place] = list(body[at : at + 3])
                    at += 3
    assert at == len(body)
    head = HEAD.pack(1, which, width, height, length, serial, milliseconds)
    return head + name + image.tobytes()
