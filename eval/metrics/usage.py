"""How evenly the style was used."""

import numpy as np
from scipy.stats import entropy

from eval.number import Number
from stylit_ref.formulae.patch_penalization import omega_best

PATCH_WIDTH = 5

NUMBERS = {
    "coverage": Number("coverage", "{:.1%}"),
    "entropy": Number("entropy", "{:.4f}"),
    "peak": Number("peak Ω/ω_best", "{:.1f}"),
    "distinct": Number("distinct assigned", "{:.1%}"),
}

DEFINITION = """\
- **coverage**: share of the style's pixels under some assigned patch; **entropy**: that of Ω over
  the style's pixels, as a share of the largest; **peak Ω/ω_best**: the largest Ω, where 1 is even;
  **distinct assigned**: different source centres in the run's own NNF over target pixels."""


def measure(scene, outcome):
    """All four numbers, if the method tells its NNF."""
    if outcome.omega is None:
        return {}
    return {
        "coverage": coverage(outcome.omega),
        "entropy": usage_entropy(outcome.omega),
        "peak": peak_usage(outcome.omega, outcome.nnf[:, :, 0].size, PATCH_WIDTH),
        "distinct": distinct_patches(outcome.nnf),
    }


def coverage(omega):
    """Share of source pixels that an assigned patch covers.

    Parameters
    ----------
    omega : (H_A, W_A) int32

    Returns
    -------
    float
    """
    return float((omega > 0).mean())


def peak_usage(omega, target_patches, patch_width):
    """Largest Ω of any source pixel over ω_best; 1 would be perfectly even.

    Parameters
    ----------
    omega : (H_A, W_A) int32
    target_patches, patch_width : int

    Returns
    -------
    float
    """
    return float(omega.max() / omega_best(patch_width, omega.size, target_patches))


def usage_entropy(omega):
    """Entropy of Ω over the source's pixels over the largest possible; 1 is perfectly even.

    Parameters
    ----------
    omega : (H_A, W_A) int32

    Returns
    -------
    float
    """
    return float(entropy(omega.ravel()) / np.log(omega.size))


def distinct_patches(nnf):
    """Number of different source centres over the number of target patches.

    Parameters
    ----------
    nnf : (H_B, W_B, 2) int32

    Returns
    -------
    float
    """
    centres = np.unique(nnf.reshape(-1, 2), axis=0)
    return len(centres) / (nnf.shape[0] * nnf.shape[1])
