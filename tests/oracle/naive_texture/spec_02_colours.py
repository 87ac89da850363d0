"""2. Colours."""


def pack(pixel):
    """Pack the channels of a pixel; a grey one has its channel three times."""
    first, second, third = (int(c) for c in (pixel if len(pixel) == 3 else [pixel[0]] * 3))
    return first + (second << 8) + (third << 16)


def distance(p, q):
    """Sum the squared differences of two packed colours."""
    return sum((((p >> shift) & 255) - ((q >> shift) & 255)) ** 2 for shift in (0, 8, 16))
