"""Published versions stay what they are, and the checker knows all of them."""

import hashlib
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import jsonschema
import pytest

import oracle
from oracle.__main__ import main
from oracle.cases import damaged_files
from oracle.families import FAMILY_OF, NEWEST, folder_of, spec_of

DIGESTS = {
    "v1": "a23247307f921b0d0b3a43e0ad296c2d1163fde9e89d5f05d04ea891f6a136f7",
    "texture/v1": "4cd33260ee79a0377252c0339eea6b360954cd21ce3d425ca086fd862d21a433",
    "realtime/v1": "85fa04e1c03c53a00cdccf08f5d7dd5b7d9a01b1e3f16f1c2c983a2ac7110d62",
    "views/v1": "6a29771cc636d55e2c5369300ad57be7dff1cbe27613613f913d5291a9b4e844",
    "interpolation/v1": "bfde738a8ce15951710ad36419d50739e8575f0a4b62ed12e0422222af338cb2",
}
"""SHA-256 of the SHA256SUMS of every version: what is published never changes."""


def test_published_versions_are_what_they_were():
    assert DIGESTS.keys() == set(FAMILY_OF)
    for version, digest in DIGESTS.items():
        assert damaged_files(version) == {}
        assert (
            hashlib.sha256((folder_of(version) / "SHA256SUMS").read_bytes()).hexdigest() == digest
        )


@pytest.mark.parametrize("version", FAMILY_OF)
def test_descriptions_follow_the_schema(version):
    text = (folder_of(version) / "case.schema.json").read_text(encoding="utf-8")
    schema = jsonschema.Draft202012Validator(json.loads(text))
    schema.check_schema(schema.schema)
    files = sorted(folder_of(version).glob("*/*/case.json"))
    assert len(files) > 40
    assert schema.schema["properties"]["version"]["const"] == version
    for file in files:
        schema.validate(json.loads(file.read_text(encoding="utf-8")))


@pytest.mark.parametrize("version", FAMILY_OF)
def test_every_version_has_its_text(version):
    assert f"\nVersion {version.rpartition('v')[2]}. " in spec_of(version).read_text(
        encoding="utf-8"
    )


def test_published_cases_are_not_made_again(capsys):
    assert main(["make"]) == 2
    assert f"{NEWEST} is published and never changes" in capsys.readouterr().err


def test_a_version_begins_with_its_schema(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("oracle.make.folder_of", lambda version: tmp_path / version)
    assert main(["make"]) == 2
    assert f"{tmp_path / NEWEST}: case.schema.json is missing" in capsys.readouterr().err


TWO_VERSIONS = """
import sys
from pathlib import Path
import numpy as np
from oracle.__main__ import main
from oracle.cases import damaged_files, write_digests
from oracle.families import folder_of

answer = folder_of("v2") / "commit_order/first/expected/order.npy"
np.save(answer, np.load(answer)[::-1])
write_digests("v2")
assert damaged_files("v1") == damaged_files("v2") == {}
Path("port_of_nothing.py").write_text("def run_case(*_): return {}")
stages = ["check", "--stages", "commit_order"]
main(stages)
print("--")
main([*stages, "--cases", "v1"])
print("--")
main([*stages, "--cases", "v1", "--module", "port_of_nothing"])
"""


@pytest.mark.slow
def test_the_checker_knows_both_of_two_versions(tmp_path):
    """A copy of the oracle with a second version, one answer of which differs."""
    copy = tmp_path / "oracle"
    shutil.copytree(Path(oracle.__file__).parent, copy)
    shutil.copytree(copy / "v1", copy / "v2")
    known = (copy / "families.py").read_text(encoding="utf-8")
    assert '("v1",)' in known
    text = known.replace('("v1",)', '("v1", "v2")')
    (copy / "families.py").write_text(text, encoding="utf-8")
    folders = os.pathsep.join([str(tmp_path), *filter(None, sys.path)])
    done = subprocess.run(
        [sys.executable, "-c", TWO_VERSIONS],
        cwd=tmp_path, env=os.environ | {"PYTHONPATH": folders},
        check=True, capture_output=True, text=True,
    )  # fmt: skip
    newest, older, nothing = done.stdout.split("\n--\n")
    assert "1 passed, 1 failed" in newest
    assert f"section 9 of {copy}/SPEC.md." in newest
    assert older == "2 passed"
    assert f"section 9 of {copy}/v1/SPEC.md." in nothing


def test_damage_is_told(tmp_path, monkeypatch, capsys):
    shutil.copytree(folder_of("v1"), tmp_path / "v1")
    ends = tmp_path / "v1" / "knee" / "ends"
    (tmp_path / "v1" / ".DS_Store").touch()
    (ends / "a.npy").unlink()
    (ends / "b.npy").write_bytes(b"")
    shutil.copytree(ends, ends.with_name("new"))
    monkeypatch.setattr("oracle.cases.folder_of", lambda version: tmp_path / version)
    assert damaged_files("v1") == {
        "knee/ends/a.npy": "is missing",
        "knee/ends/b.npy": "differs from SHA256SUMS",
        "knee/new/b.npy": "is not in SHA256SUMS",
        "knee/new/case.json": "is not in SHA256SUMS",
        "knee/new/expected/x.npy": "is not in SHA256SUMS",
    }
    assert main(["check", "--stages", "philox"]) == 2
    assert "knee/ends/a.npy: is missing" in capsys.readouterr().err
