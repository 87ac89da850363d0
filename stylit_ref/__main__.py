"""``python -m stylit_ref``: the same as ``stylit-ref``."""

from stylit_ref.cli import command

command()
