"""Which systems have cases: a row each, and a folder of versions."""

from pathlib import Path
from typing import NamedTuple


class Family(NamedTuple):
    """The cases of a system.

    Attributes
    ----------
    name : str
    versions : tuple of str
        Their folders below this one, oldest first, by which ``--cases`` names them: the text is
        ``SPEC.md`` beside them. A version never changes; what would change it is the next one.
    sections : dict of str to str
        Section of the text of every stage. In an order in which a stage needs only those before
        it: the first that fails is the one to mend.
    """

    name: str
    versions: tuple[str, ...]
    sections: dict[str, str]


STYLIZATION = Family(
    "stylization",
    ("v1",),
    {
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
    },
)

FAMILIES = (STYLIZATION,)

FAMILY_OF = {version: family for family in FAMILIES for version in family.versions}

NEWEST = STYLIZATION.versions[-1]
"""The version that is checked where none is named."""


def folder_of(version: str) -> Path:
    """Where the cases of a version lie."""
    return Path(__file__).parent / version


def stages_of(version: str) -> tuple[str, ...]:
    """The stages that a version has cases of; a later one of its family may have more."""
    folder = folder_of(version)
    return tuple(stage for stage in FAMILY_OF[version].sections if (folder / stage).is_dir())


def spec_of(version: str) -> Path:
    """The text that the cases of a version pin: an older one's is kept among them."""
    folder = folder_of(version)
    is_newest = version == FAMILY_OF[version].versions[-1]
    return (folder.parent if is_newest else folder) / "SPEC.md"
