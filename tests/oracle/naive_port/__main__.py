"""The program: reads a case from one folder and writes its outputs into another."""

import sys
from pathlib import Path

if not __package__:  # run by the folder's name
    sys.path.insert(0, str(Path(__file__).parents[1]))

from naive_port.spec_17_cases import read_case, run_case, write_outputs

NOT_OFFERED = 77


def main(arguments):
    """Do one case; returns the exit code."""
    if len(arguments) != 2:
        print("usage: python naive_port INPUT_FOLDER OUTPUT_FOLDER", file=sys.stderr)
        return 2
    source, destination = map(Path, arguments)
    try:
        outputs = run_case(*read_case(source))
    except NotImplementedError:
        return NOT_OFFERED
    write_outputs(outputs, destination)
    return 0


sys.exit(main(sys.argv[1:]))
