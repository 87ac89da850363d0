"""What the kernels of the search need of the textures."""

import numpy as np

from gpu_cuda.host.device import BLOCK, launch
from gpu_cuda.host.memory import kept_on_device
from gpu_cuda.metric_constants import MetricConstants


def metric_arrays(textures):
    """Ā, B̄, weights, G, M_B and M_A, as kernels take them.

    The textures are flat arrays of words. Without a guide map nothing reads the last three: Ā
    stands in for them.
    """
    means = textures.guide_map, textures.target_sums, textures.source_sums
    if textures.guide_map is None:
        source = textures.source
        sums = source.view(np.uint16)
        means = source.reshape(1, source.size).view(np.bool_), sums, sums
    weights = kept_on_device(textures.pair_weights)
    return words(textures.source), words(textures.target), weights, *means


def words(texture):
    """A packed texture of the device as a flat array of uint32."""
    return texture.reshape(texture.size).view(np.uint32)


def launch_search(make_kernel, proposal, *parameters, block=BLOCK, shared=False):
    """Run Kernel_Propagation or Kernel_RandomSearch.

    Parameters
    ----------
    make_kernel : callable
        As :func:`gpu_cuda.propagation.make_kernel`.
    proposal : stylit_ref.metric.proposal.Proposal
    *parameters
        The kernel's last arguments.
    block : (int, int)
        Threads of a block along x and y.
    shared : bool
        Whether a block reads its target patches from shared memory (5.1).
    """
    textures, omega_sums, occurrence_weight, patch_width, *assignments = proposal
    launch(
        make_kernel(MetricConstants.of(textures, patch_width), block, shared),
        proposal.delta.shape,
        *metric_arrays(textures),
        omega_sums,
        occurrence_weight,
        *assignments,
        *parameters,
        block=block,
    )
