"""How evenly the style was used."""

import numpy as np
from scipy.stats import entropy

from stylit_ref.formulae.patch_penalization import omega_best


def coverage(omega):
    """Share of source pixels that some assigned patch covers.

    Parameters
    ----------
    omega : (H_A, W_A) int32

    Returns
    -------
    float
    """
    return float((omega > 0).mean())


def peak_usage(omega, target_patches, patch_width):
    """The most used source pixel's Ω over ω_best; 1 would be perfectly even.

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
    """Different source centres over target patches.

    Parameters
    ----------
    nnf : (H_B, W_B, 2) int32

    Returns
    -------
    float
    """
    centres = np.unique(nnf.reshape(-1, 2), axis=0)
    return len(centres) / (nnf.shape[0] * nnf.shape[1])
