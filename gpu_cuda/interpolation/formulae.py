"""The library's formulae in the form that kernels can call."""

from gpu_cuda.host.device import formula
from stylit_ref.realtime.formulae import packed_nnf
from stylit_ref.views.formulae import shift
from stylit_ref.views.interpolation.formulae import weights

column_of = formula(packed_nnf.column_of)
packed = formula(packed_nnf.packed)
row_of = formula(packed_nnf.row_of)
shifted = formula(shift.shifted)
weighted_mean = formula(weights.weighted_mean)
