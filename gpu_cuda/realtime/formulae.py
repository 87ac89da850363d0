"""The library's formulae in the form that kernels can call."""

from gpu_cuda.host.device import formula
from stylit_ref.randomness import random_stream
from stylit_ref.realtime.formulae import (
    average,
    grid,
    packed_nnf,
    random_candidate,
    renewal,
    upsampling,
)

bilinear = formula(average.bilinear)
coarse = formula(renewal.coarse)
column_of = formula(packed_nnf.column_of)
covering_entries = formula(grid.covering_entries)
fine = formula(renewal.fine)
first_centre = formula(grid.first_centre)
is_old = formula(renewal.is_old)
last_centre = formula(grid.last_centre)
mean_of = formula(average.mean_of)
mean_of_four = formula(average.mean_of_four)
packed = formula(packed_nnf.packed)
random_column = formula(random_candidate.random_column)
random_row = formula(random_candidate.random_row)
random_words = formula(random_stream.random_words)
row_of = formula(packed_nnf.row_of)
upsampled = formula(upsampling.upsampled)
