"""The library's formulae in the form that kernels can call."""

from gpu_cuda.host.device import formula
from stylit_ref.views.formulae import fold, shift, silhouette, vectors

differ = formula(vectors.differ)
fixed = formula(vectors.fixed)
folded = formula(fold.folded)
is_consistent = formula(vectors.is_consistent)
is_nearer = formula(silhouette.is_nearer)
is_step = formula(silhouette.is_step)
representative = formula(shift.representative)
shifted = formula(shift.shifted)
spread = formula(fold.spread)
