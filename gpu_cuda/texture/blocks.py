"""The blocks that a table of the dynamic programming is subdivided into (section 7, Figure 8)."""

from typing import NamedTuple


class Blocks(NamedTuple):
    """Sizes of the blocks.

    Attributes
    ----------
    columns, rows : int
        What a block computes: B_w and B_h. It also computes what these depend on, up to J columns
        more on either side for every row above its last.
    threads : int
        Of a block; they share its columns.
    """

    columns: int
    rows: int
    threads: int

    @classmethod
    def default(cls, max_jump):
        """Sizes for a largest jump J.

        B_w is the paper's. Its B_h = 32 sqrt(J - 16) / J is imaginary below J = 16, and 0 there;
        here it is the height at which a block computes at most as much for its padding as for
        itself. The threads are the paper's, for that height: 32 + B_h J, in whole warps.
        """
        columns = 32 + max_jump
        rows = 1 + columns // max_jump
        return cls(columns, rows, -(-(32 + rows * max_jump) // 32) * 32)
