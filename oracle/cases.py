"""Cases: a stage of the algorithm with its input and what it must give."""

import hashlib
import json
from dataclasses import dataclass
from pathlib import Path

import numpy as np

VERSIONS = ("v1",)
"""A version never changes; what would change it is the next one."""

NEWEST = VERSIONS[-1]

SECTIONS = {
    "philox": "4",
    "weights": "2",
    "random_nnf": "5",
    "downsample": "6",
    "upsample_nnf": "6",
    "occurrence": "1",
    "delta": "3",
    "phi": "3",
    "guide_map": "12",
    "white_delta": "12",
    "propagation": "7",
    "random_search": "8",
    "commit_order": "9",
    "commit": "9",
    "iteration": "10",
    "vote": "11",
    "level": "13",
    "run": "13",
    "lower_bound": "16",
    "budget": "14",
    "knee": "14",
    "invert_nnf": "15",
    "settle": "15",
    "stylit_search": "15",
    "stylit_run": "15",
}
"""Section of SPEC.md of every stage. In an order in which a stage needs only those before it: the
first that fails is the one to mend."""

STAGES = tuple(SECTIONS)


class CaseError(Exception):
    """One sentence on an array that cannot be read, or on a port that gives none."""


@dataclass(frozen=True)
class Case:
    """A stage, its input, and what it must give.

    Attributes
    ----------
    version : str
        One of :data:`VERSIONS`.
    stage, name : str
    section : str
        Of SPEC.md.
    parameters : dict
        Numbers, text and lists.
    tolerances : dict of str to float
        Relative, of expected arrays that need not be equal bit for bit.
    arrays, expected : dict of str to array
    """

    version: str
    stage: str
    name: str
    section: str
    parameters: dict
    tolerances: dict[str, float]
    arrays: dict[str, np.ndarray]
    expected: dict[str, np.ndarray]

    @property
    def title(self):
        """Stage and name."""
        return f"{self.stage}/{self.name}"


def folder_of(version):
    """Where the cases of a version lie."""
    return Path(__file__).with_name(version)


def spec_of(version):
    """The text that the cases of a version pin: an older one's is kept among them."""
    folder = folder_of(version)
    return (folder.parent if version == NEWEST else folder) / "SPEC.md"


def write_input(case, folder):
    """Write what a port sees of a case."""
    folder.mkdir(parents=True, exist_ok=True)
    description = {
        "version": case.version,
        "stage": case.stage,
        "name": case.name,
        "section": case.section,
        "parameters": case.parameters,
        "tolerances": case.tolerances,
    }
    text = json.dumps(description, indent=1, ensure_ascii=False)
    (folder / "case.json").write_text(text + "\n", encoding="utf-8")
    _write_arrays(folder, case.arrays)


def write_case(case):
    """Write a case with what it must give."""
    folder = folder_of(case.version) / case.stage / case.name
    write_input(case, folder)
    _write_arrays(folder / "expected", case.expected)


def write_digests(version):
    """Write the SHA-256 of every file of a version, so that a change does not go unnoticed."""
    folder = folder_of(version)
    lines = [f"{_sha256(file)}  {file.relative_to(folder).as_posix()}" for file in _files(folder)]
    (folder / "SHA256SUMS").write_text("\n".join(lines) + "\n", encoding="utf-8")


def damaged_files(version):
    """Files of a version that are missing, differ from its digests, or have none.

    Returns
    -------
    dict of str to str
        What is wrong with each.
    """
    folder, damaged = folder_of(version), {}
    lines = (folder / "SHA256SUMS").read_text(encoding="utf-8").splitlines()
    digests = {name: digest for digest, name in (line.split("  ", 1) for line in lines)}
    for name, digest in digests.items():
        if not (folder / name).is_file():
            damaged[name] = "is missing"
        elif _sha256(folder / name) != digest:
            damaged[name] = "differs from SHA256SUMS"
    for file in _files(folder):  # what is no part of a case, as .DS_Store, does no harm
        name = file.relative_to(folder).as_posix()
        if file.suffix in (".json", ".npy") and name not in digests:
            damaged[name] = "is not in SHA256SUMS"
    return damaged


def read_cases(version, stages=STAGES):
    """The cases of some stages, in the order of the stages."""
    for stage in stages:
        for file in sorted((folder_of(version) / stage).glob("*/case.json")):
            description = json.loads(file.read_text(encoding="utf-8"))
            yield Case(
                description["version"],
                stage,
                description["name"],
                description["section"],
                description["parameters"],
                description["tolerances"],
                _read_arrays(file.parent),
                _read_arrays(file.parent / "expected"),
            )


def read_array(file):
    """An array of a file; never an object that was pickled.

    Raises
    ------
    CaseError
        If there is none.
    """
    if not file.exists():
        raise CaseError(f"{file.name} is not there")
    if not file.is_file():  # a pipe would be waited for
        raise CaseError(f"{file.name} is no file")
    try:
        with file.open("rb") as stream:
            return np.lib.format.read_array(stream, allow_pickle=False)
    except Exception as error:  # whatever the text of a header brings NumPy's parser to
        raise CaseError(f"{file.name} cannot be read as an array: {error}") from None


def _read_arrays(folder):
    return {file.stem: read_array(file) for file in sorted(folder.glob("*.npy"))}


def _write_arrays(folder, arrays):
    folder.mkdir(parents=True, exist_ok=True)
    for name, array in arrays.items():
        np.save(folder / f"{name}.npy", np.ascontiguousarray(array).reshape(np.shape(array)))


def _files(folder):
    return sorted(
        file for file in folder.rglob("*") if file.is_file() and file.name != "SHA256SUMS"
    )


def _sha256(file):
    return hashlib.sha256(file.read_bytes()).hexdigest()
