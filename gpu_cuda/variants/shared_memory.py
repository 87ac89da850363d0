"""The passes with the target patches of a block in shared memory (thesis 5.1).

The results are those of the plain kernels, byte for byte.
"""

import gpu_cuda
from gpu_cuda.host.device import BLOCK
from gpu_cuda.metric.launch_search import launch_search
from gpu_cuda.passes.propagation import make_kernel as make_propagation_kernel
from gpu_cuda.passes.random_search import make_kernel as make_random_search_kernel
from stylit_ref.formulae.search_radii import number_of_radii
from stylit_ref.machine.replaced import replaced
from stylit_ref.metric.proposal import Proposal


def in_blocks(block, shared):
    """The passes, with a search that runs in blocks of this size.

    Parameters
    ----------
    block : (int, int)
        Threads of a block along x and y.
    shared : bool
        Whether a block's target patches lie in shared memory.
    """

    def propagation(
        textures, omega_sums, occurrence_weight, patch_width,
        nnf, delta, new_nnf, new_delta, distance,
    ):  # fmt: skip
        """As :func:`gpu_cuda.propagation`."""
        proposal = Proposal(
            textures, omega_sums, occurrence_weight, patch_width, nnf, delta, new_nnf, new_delta
        )
        launch_search(make_propagation_kernel, proposal, distance, block=block, shared=shared)

    def random_search(
        textures, omega_sums, occurrence_weight, patch_width,
        nnf, delta, new_nnf, new_delta, stream, side=None,
    ):  # fmt: skip
        """As :func:`gpu_cuda.random_search`."""
        proposal = Proposal(
            textures, omega_sums, occurrence_weight, patch_width, nnf, delta, new_nnf, new_delta
        )
        radii = number_of_radii(side or max(delta.shape))
        launch_search(
            make_random_search_kernel, proposal, stream, radii, block=block, shared=shared
        )

    return replaced(gpu_cuda, propagation=propagation, random_search=random_search)


passes = in_blocks(BLOCK, shared=True)
"""All passes; the search uses shared memory."""
