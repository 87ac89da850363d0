"""The dense methods of the library, with the time of the processor."""

import time
from dataclasses import dataclass, replace

from eval.methods.stylit_ref import StylitRef, compile_kernels


@dataclass(frozen=True)
class Dense(StylitRef):
    """A run of :func:`stylit_ref.stylize`; its ``stages`` are ``cpu``, seconds of the processor."""

    def run(self, scene, seed, progress=None):
        """As :meth:`eval.methods.stylit_ref.StylitRef.run`."""
        compile_kernels(scene, self.params)
        before = time.process_time()
        outcome = super().run(scene, seed, progress)
        return replace(outcome, stages={"cpu": time.process_time() - before})
