"""Run every stage with the library's own passes, or with another module's."""

from types import ModuleType
from typing import NamedTuple

from oracle.families import INTERPOLATION, REALTIME, STYLIZATION, TEXTURE, VIEWS, Family
from oracle.stages import (
    interpolation,
    realtime,
    realtime_frames,
    runs,
    stylit,
    stylization,
    texture,
    texture_runs,
    views,
    views_runs,
)
from oracle.stages.stage import Stage
from stylit_ref import passes as stylization_passes
from stylit_ref.realtime import passes as realtime_passes
from stylit_ref.texture import passes as texture_passes
from stylit_ref.views import passes as views_passes
from stylit_ref.views.interpolation import passes as interpolation_passes


class System(NamedTuple):
    """The passes and stages of a family.

    Attributes
    ----------
    passes : module
        The library's own.
    stages : dict of str to Stage
    """

    passes: ModuleType
    stages: dict[str, Stage]


SYSTEMS = {
    STYLIZATION.name: System(stylization_passes, stylization.STAGES | runs.STAGES | stylit.STAGES),
    TEXTURE.name: System(texture_passes, texture.STAGES | texture_runs.STAGES),
    REALTIME.name: System(realtime_passes, realtime.STAGES | realtime_frames.STAGES),
    VIEWS.name: System(views_passes, views.STAGES | views_runs.STAGES),
    INTERPOLATION.name: System(interpolation_passes, interpolation.STAGES),
}
"""The system of each family, by the family's name."""


def is_offered(family: Family, stage: str, passes: ModuleType) -> bool:
    """Whether a module can run a stage: it has the stage's passes, or is the library's own."""
    system = SYSTEMS[family.name]
    if passes is system.passes:
        return True
    needed = system.stages[stage].passes
    return bool(needed) and all(hasattr(passes, name) for name in needed)


def run_case(
    family: Family, stage: str, parameters: dict, arrays: dict, passes: ModuleType
) -> dict:
    """Run a stage.

    Parameters
    ----------
    family : Family
    stage : str
        One of the family's.
    parameters : dict
    arrays : dict of str to array
    passes : module
        The library's own, or another that offers the same.

    Returns
    -------
    dict of str to array
    """
    return SYSTEMS[family.name].stages[stage].do(passes, parameters, arrays)
