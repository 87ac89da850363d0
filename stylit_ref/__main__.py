"""``stylit-ref`` and ``python -m stylit_ref``: what must be right before the library is loaded."""

import os
import sys


def command() -> None:
    """Entry point of ``stylit-ref``."""
    threads = os.environ.get("NUMBA_NUM_THREADS", "1")
    if not (threads.isdecimal() and int(threads) > 0):  # Numba ends the import by a traceback
        sys.exit(_refuse(f"NUMBA_NUM_THREADS is {threads!r}; it must be an integer of at least 1"))
    try:
        from stylit_ref.cli import command as run_command
    except ModuleNotFoundError as error:
        sys.exit(
            _refuse(
                f"the package {error.name!r} is missing; install stylit-ref with all it depends on "
                "(python -m oracle checks a port with NumPy alone)"
            )
        )
    except KeyboardInterrupt:
        print("stylit-ref: interrupted", file=sys.stderr)
        sys.exit(130)
    run_command()


def _refuse(sentence):
    print(f"stylit-ref: {sentence}", file=sys.stderr)
    return 2


if __name__ == "__main__":
    command()
