"""Write a version of the cases of a family."""

import shutil

from oracle.cases import write_case, write_digests
from oracle.families import (
    FAMILY_OF,
    INTERPOLATION,
    REALTIME,
    STYLIZATION,
    TEXTURE,
    VIEWS,
    folder_of,
)
from oracle.make.interpolation import interpolation_cases
from oracle.make.realtime import realtime_cases
from oracle.make.stylization import stylization_cases
from oracle.make.texture import texture_cases
from oracle.make.views import views_cases
from oracle.progress import progress
from stylit_ref.errors import InputError

MAKERS = {
    STYLIZATION.name: stylization_cases,
    TEXTURE.name: texture_cases,
    REALTIME.name: realtime_cases,
    VIEWS.name: views_cases,
    INTERPOLATION.name: interpolation_cases,
}
"""For each family a function ``(version) -> cases``."""


def make_version(version: str) -> None:
    """Write the cases of a version that is not yet published.

    Raises
    ------
    InputError
        If the version is published or not the newest, or if its schema is missing.
    """
    folder, family = folder_of(version), FAMILY_OF[version]
    if (folder / "SHA256SUMS").exists() or version != family.versions[-1]:
        raise InputError(
            f"{version} is published and never changes; add a version to {family.name} in "
            "oracle/families.py"
        )
    if not (folder / "case.schema.json").exists():
        raise InputError(
            f"{folder}: case.schema.json is missing; copy that of the previous version"
        )
    for stage in folder.glob("*/"):
        shutil.rmtree(stage)
    for case in progress(MAKERS[family.name](version)):
        write_case(case)
    write_digests(version)
