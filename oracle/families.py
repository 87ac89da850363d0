"""The systems that have cases, and the versions of each."""

from pathlib import Path
from typing import NamedTuple


class Family(NamedTuple):
    """The cases of a system.

    Attributes
    ----------
    name : str
    versions : tuple of str
        Their folders below this one, oldest first; ``--cases`` takes these names. A published
        version never changes: any change makes a new version.
    sections : dict of str to str
        The section of SPEC.md that describes each stage. A stage builds only on stages before
        it, so the first stage that fails is the one to mend.
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

TEXTURE = Family(
    "texture",
    ("texture/v1",),
    {
        "white_noise": "4",
        "grid": "4",
        "exemplars": "3",
        "seams": "5",
        "guide_costs": "5",
        "candidates": "6",
        "costs": "7",
        "cut": "8",
        "closed_cut": "8",
        "alignment": "9",
        "raster": "10",
        "change": "11",
        "iteration": "12",
        "run": "12",
    },
)

REALTIME = Family(
    "realtime",
    ("realtime/v1",),
    {
        "pack_stage": "2",
        "pack_all": "2",
        "pack_principal": "2",
        "halve": "3",
        "entry_labels": "3",
        "random_nnf": "4",
        "weights": "5",
        "records": "5",
        "energy": "5",
        "search": "6",
        "blend": "7",
        "upsample_nnf": "8",
        "upsample_picture": "8",
        "frame": "9",
        "warm_frame": "9",
        "stroke": "9",
        "dense_nnf": "10",
        "vote": "10",
        "finish": "10",
    },
)

VIEWS = Family(
    "views",
    ("views/v1",),
    {
        "shift_map": "2",
        "shift_picture": "2",
        "cancel": "3",
        "compose": "3",
        "splat": "4",
        "invert": "4",
        "unhidden": "4",
        "rims": "5",
        "beside": "5",
        "along": "5",
        "motion": "6",
        "fold": "7",
        "weights": "7",
        "plan": "8",
        "iteration": "9",
        "run": "9",
    },
)

INTERPOLATION = Family(
    "interpolation",
    ("interpolation/v1",),
    {
        "around": "2",
        "transfer": "3",
        "rasterize": "4",
        "splat": "4",
        "shift": "5",
        "fetch": "5",
        "vote": "6",
        "search": "6",
        "mix": "7",
        "mix_shifted": "7",
        "frame": "8",
    },
)

FAMILIES = STYLIZATION, TEXTURE, REALTIME, VIEWS, INTERPOLATION

FAMILY_OF = {version: family for family in FAMILIES for version in family.versions}

NEWEST = STYLIZATION.versions[-1]
"""The version that is checked by default."""


def folder_of(version: str) -> Path:
    """The folder of the cases of a version."""
    return Path(__file__).parent / version


def stages_of(version: str) -> tuple[str, ...]:
    """The stages that a version has cases of; later versions may have more."""
    folder = folder_of(version)
    return tuple(stage for stage in FAMILY_OF[version].sections if (folder / stage).is_dir())


def spec_of(version: str) -> Path:
    """The SPEC.md of a version; that of an older version lies among its cases."""
    folder = folder_of(version)
    is_newest = version == FAMILY_OF[version].versions[-1]
    return (folder.parent if is_newest else folder) / "SPEC.md"
