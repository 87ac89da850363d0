"""What Numba compiles while one listens."""

from numba.core import event


class Compiled(event.Listener):
    """Names of what is compiled while it listens, in order."""

    def __init__(self):
        self.names = []

    def on_start(self, event):
        self.names.append(event.data["dispatcher"].__name__)

    def on_end(self, event):
        pass
