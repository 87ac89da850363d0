"""The bundled scenes, as the studio offers them."""

from collections.abc import Iterator
from pathlib import Path

from stylit_ref.errors import InputError
from stylit_ref.studio.scene_files.layers_in import layers_in
from stylit_ref.studio.scene_files.offer import Offer

_TARGETS = "golem", "teapot", "hand", "helmet", "pumpkin", "scorpion", "stego"


def bundled_offers() -> Iterator[Offer]:
    """The turntable, and small targets under the same light.

    Raises
    ------
    InputError
        If the scenes are not installed.
    """
    turntable, small = _folders()
    if turntable.is_dir():
        steps = sorted((turntable / "turntable").iterdir())
        source = layers_in(turntable / "source")
        yield Offer("turntable", "Golem that turns", source, [layers_in(step) for step in steps])
    source = layers_in(small / "source")
    for name in _TARGETS:
        yield Offer(name, f"{name.capitalize()} (small)", source, [layers_in(small / name)])


def bundled_source() -> Path:
    """The folder of the render passes of the sphere that is painted first.

    Raises
    ------
    InputError
        If the scenes are not installed.
    """
    return next(folder for folder in _folders() if folder.is_dir()) / "source"


def bundled_style(name: str) -> Path:
    """A painting of that sphere by its name, such as ``oil``.

    Raises
    ------
    InputError
        If there is none.
    """
    styles = {style.stem: style for style in sorted((bundled_source() / "styles").iterdir())}
    if name not in styles:
        raise InputError(
            f"{name}: no such file, and no bundled painting; those are {', '.join(styles)}"
        )
    return styles[name]


def _folders() -> tuple[Path, Path]:
    """Of the turntable, which need not be there, and of the small scenes."""
    try:
        from data_gen import guides, turntable
    except ModuleNotFoundError:
        raise InputError(
            "the scenes are not installed with this package; name a TARGET and a --source"
        ) from None
    return turntable.BUNDLED, Path(guides.__file__).with_name("bundled")
