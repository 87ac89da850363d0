"""How the kernels of the search are launched, plain and in shared memory."""

from gpu_cuda.host.device import BLOCK, launch
from gpu_cuda.metric.constants import MetricConstants
from gpu_cuda.metric.textures import metric_arrays


def launch_search(make_kernel, proposal, *parameters, block=BLOCK, shared=False):
    """Run Kernel_Propagation or Kernel_RandomSearch.

    Parameters
    ----------
    make_kernel : callable
        ``(constants, block, shared) -> kernel``, cached.
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
