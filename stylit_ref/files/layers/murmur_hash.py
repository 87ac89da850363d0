"""MurmurHash3_32, by which Cryptomatte turns a name into a number."""

_MASK = 0xFFFFFFFF


def murmur_hash(data: bytes, seed: int = 0) -> int:
    """Hash bytes by MurmurHash3_x86_32, which Austin Appleby put into the public domain.

    Parameters
    ----------
    data : bytes
    seed : int
        From 0 to 2**32 - 1.

    Returns
    -------
    int
        From 0 to 2**32 - 1.
    """
    value = seed
    whole = len(data) // 4 * 4
    for start in range(0, whole, 4):
        value ^= _scrambled(int.from_bytes(data[start : start + 4], "little"))
        value = (_rotated(value, 13) * 5 + 0xE6546B64) & _MASK
    value ^= _scrambled(int.from_bytes(data[whole:], "little"))
    value ^= len(data)
    value = ((value ^ value >> 16) * 0x85EBCA6B) & _MASK
    value = ((value ^ value >> 13) * 0xC2B2AE35) & _MASK
    return value ^ value >> 16


def _scrambled(block):
    return _rotated(block * 0xCC9E2D51 & _MASK, 15) * 0x1B873593 & _MASK


def _rotated(value, bits):
    return (value << bits | value >> (32 - bits)) & _MASK
