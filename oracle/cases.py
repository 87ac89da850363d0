"""Cases: a stage of the algorithm, its input and its expected output."""

import hashlib
import json
from dataclasses import dataclass

import numpy as np

from oracle.families import folder_of, stages_of


class CaseError(Exception):
    """An array cannot be read, or a port gives none; the message is one sentence."""


@dataclass(frozen=True)
class Case:
    """A stage, its input and its expected output.

    Attributes
    ----------
    version : str
        One of :class:`oracle.families.Family`.
    stage, name : str
    section : str
        Section of the version's SPEC.md.
    parameters : dict
        Numbers, text and lists.
    tolerances : dict of str to float
        Relative tolerances of the expected arrays that need not be equal bit for bit.
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


def write_input(case, folder):
    """Write the part of a case that a port may see."""
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
    """Write a case with its expected output."""
    folder = folder_of(case.version) / case.stage / case.name
    write_input(case, folder)
    _write_arrays(folder / "expected", case.expected)


def write_digests(version):
    """Write the SHA-256 of every file of a version, so that a later change is noticed."""
    folder = folder_of(version)
    lines = [f"{_sha256(file)}  {file.relative_to(folder).as_posix()}" for file in _files(folder)]
    (folder / "SHA256SUMS").write_text("\n".join(lines) + "\n", encoding="utf-8")


def damaged_files(version):
    """Files of a version that are missing, that differ from their digest, or that have none.

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
    for file in _files(folder):  # other files, such as .DS_Store, do no harm
        name = file.relative_to(folder).as_posix()
        if file.suffix in (".json", ".npy") and name not in digests:
            damaged[name] = "is not in SHA256SUMS"
    return damaged


def read_cases(version, stages=None):
    """Read the cases of some stages, or of all, in the order of the stages."""
    for stage in stages_of(version) if stages is None else stages:
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
    """Read the array of a file; a pickled object is refused.

    Raises
    ------
    CaseError
        If the file holds no array.
    """
    if not file.exists():
        raise CaseError(f"{file.name} is missing")
    if not file.is_file():  # reading a pipe might never end
        raise CaseError(f"{file.name} is not a regular file")
    try:
        with file.open("rb") as stream:
            return np.lib.format.read_array(stream, allow_pickle=False)
    except Exception as error:  # a broken header can make NumPy's parser raise anything
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
