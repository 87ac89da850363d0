"""``python -m stylit_ref.cli``: the same as ``stylit-ref``."""

from stylit_ref.cli import command

command()
