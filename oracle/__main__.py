"""``python -m oracle``: make the cases anew."""

import argparse
import shutil
import sys

from tqdm import tqdm

from oracle.cases import VERSIONS, folder_of, write_case, write_digests
from oracle.make import cases


def main(arguments=None):
    """Write the newest version's cases; returns the exit code."""
    parser = argparse.ArgumentParser(prog="python -m oracle", description=__doc__)
    parser.add_argument("what", choices=["make"])
    parser.parse_args(arguments)
    version = VERSIONS[-1]
    for folder in folder_of(version).glob("*/"):
        shutil.rmtree(folder)
    for case in tqdm(cases(), unit="case", disable=None):
        write_case(case)
    write_digests(version)
    return 0


if __name__ == "__main__":
    sys.exit(main())
