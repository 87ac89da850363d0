"""What methods have in common that run on the processor alone."""

import sys

from eval.device import processor
from stylit_ref.machine.code_digest import code_digest


class OnProcessor:
    """A method whose result depends on its file and on what that imports, CUDA kernels left out.

    The digest is taken when the class is made: a file that is edited later is not what runs.
    """

    def __init_subclass__(cls):
        super().__init_subclass__()
        cls._code = code_digest(sys.modules[cls.__module__], without=("gpu_cuda",))

    @property
    def code(self):
        """Digest of the algorithm."""
        return self._code

    @property
    def device(self):
        """Name of the processor."""
        return processor()
