"""The parser of every command."""

import argparse

from stylit_ref.errors import one_line


class Parser(argparse.ArgumentParser):
    """Refuses in one sentence, as everything else does."""

    def error(self, message):
        """End with exit code 2."""
        self.exit(2, f"{self.prog}: {one_line(message)} (--help shows the options)\n")

    def flag_of(self, parameter: str) -> str:
        """What a parameter of the Python interface is called here.

        Parameters
        ----------
        parameter : str

        Returns
        -------
        str
            The flag that sets it, or ``parameter`` itself where no flag does.
        """
        for action in self._actions:
            if action.dest == parameter and action.option_strings:
                return action.option_strings[0]
        return parameter
