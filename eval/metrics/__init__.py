"""Metrics of a run, one file each.

A file has

- ``NUMBERS``: a :class:`eval.number.Number` for each number it gives, by name;
- ``DEFINITION``: explains the numbers, as an item of a Markdown list;
- ``measure(scene, outcome)``: the numbers by name, without those that do not apply. Those of a
  :class:`eval.textures.Texture` give none for a scene of stylization.

Every file in this folder is a metric; no list has to name it.
"""

from importlib import import_module
from pkgutil import iter_modules

from stylit_ref.machine.code_digest import code_digest

METRICS = {
    module.name: import_module(f"{__name__}.{module.name}") for module in iter_modules(__path__)
}
"""The modules of all metrics, by name."""

CODES = {name: code_digest(module, without=("gpu_cuda",)) for name, module in METRICS.items()}
"""Digest of the code that each metric runs."""

NUMBERS = {name: number for metric in METRICS.values() for name, number in metric.NUMBERS.items()}
"""Title and format of every number."""


def definitions(names):
    """The definitions of some numbers, as a Markdown list."""
    return "\n".join(
        metric.DEFINITION
        for metric in METRICS.values()
        if not metric.NUMBERS.keys().isdisjoint(names)
    )
