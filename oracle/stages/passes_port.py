"""A port that offers passes: the library runs its algorithms with them."""

from importlib import import_module

from oracle.cases import Case
from oracle.compare import NotOfferedError
from oracle.families import FAMILY_OF
from oracle.stages import SYSTEMS, is_offered, run_case
from stylit_ref.errors import InputError


class PassesPort:
    """A Python module with some of the passes of a system, as ``stylit_ref.passes`` has them.

    Parameters
    ----------
    version : str
        Version of the cases.
    name : str, optional
        Name of the module; the library's own passes by default.

    Raises
    ------
    InputError
        If the module has no pass.
    """

    def __init__(self, version: str, name: str | None = None):
        system = SYSTEMS[FAMILY_OF[version].name]
        self.name = system.passes.__name__ if name is None else name
        module = import_module(self.name)
        needed = {need for stage in system.stages.values() for need in stage.passes}
        if not any(hasattr(module, need) for need in needed):
            raise InputError(
                f"{name!r} offers neither run_case nor a pass of {system.passes.__name__}",
                parameter="module",
            )

    def __call__(self, case: Case) -> dict:
        """The output of the passes for a case."""
        module, family = import_module(self.name), FAMILY_OF[case.version]
        if not is_offered(family, case.stage, module):
            raise NotOfferedError
        return run_case(family, case.stage, case.parameters, dict(case.arrays), module)
