"""What a seed may be."""

from numbers import Integral

from stylit_ref.errors import InputError, shown


def check_seed(seed: int) -> None:
    """A seed is 64 bits.

    Raises
    ------
    InputError
        If it is no integer from 0 to 2**64 - 1.
    """
    if not isinstance(seed, Integral) or not 0 <= seed < 1 << 64:
        raise InputError(
            f"is {shown(seed)}; it must be an integer from 0 to 2**64 - 1", parameter="seed"
        )
