"""``python -m oracle make``: write the cases of the newest version, until it is published."""

import argparse
import shutil
import sys

from tqdm import tqdm

from oracle.cases import NEWEST, folder_of, write_case, write_digests
from oracle.make import cases


def main(arguments=None):
    """Write the newest version's cases; returns the exit code."""
    parser = argparse.ArgumentParser(prog="python -m oracle", description=__doc__)
    parser.add_argument("what", choices=["make"])
    parser.parse_args(arguments)
    folder = folder_of(NEWEST)
    if (folder / "SHA256SUMS").exists():
        print(
            f"oracle: {folder.name} has its SHA256SUMS and never changes; add a version to "
            "VERSIONS in oracle/cases.py",
            file=sys.stderr,
        )
        return 2
    if not (folder / "case.schema.json").exists():
        print(
            f"oracle: {folder} needs its case.schema.json; begin with that of the version before",
            file=sys.stderr,
        )
        return 2
    for stage in folder.glob("*/"):
        shutil.rmtree(stage)
    for case in tqdm(cases(), unit="case", disable=None):
        write_case(case)
    write_digests(NEWEST)
    return 0


if __name__ == "__main__":
    sys.exit(main())
