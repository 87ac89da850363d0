"""Which passes a case asks for."""


class Listening:
    """Passes of a module, and which of them were asked for."""

    def __init__(self, passes):
        self.passes, self.heard = passes, set()

    def __getattr__(self, name):
        self.heard.add(name)
        return getattr(self.passes, name)
