"""The bundled scenes, as the studio offers them."""

from collections.abc import Iterator
from pathlib import Path

from stylit_ref.errors import InputError
from stylit_ref.studio.scene_files.layers_in import layers_in
from stylit_ref.studio.scene_files.offer import Offer

_TARGETS = "golem", "teapot", "hand", "helmet", "pumpkin", "scorpion", "stego"


def bundled_source() -> Path:
    """The folder of the sphere's render passes.

    Raises
    ------
    InputError
        If the scenes are not installed.
    """
    return _bundled() / "source"


def bundled_offers() -> Iterator[Offer]:
    """All targets under the sphere's light.

    Raises
    ------
    InputError
        If the scenes are not installed.
    """
    bundled = _bundled()
    source = layers_in(bundled / "source")
    for name in _TARGETS:
        yield Offer(name, name.capitalize(), source, [layers_in(bundled / name)])


def _bundled() -> Path:
    try:
        from data_gen import guides
    except ModuleNotFoundError:
        raise InputError(
            "the scenes are not installed with this package; name a TARGET and a --source"
        ) from None
    return Path(guides.__file__).with_name("bundled")
