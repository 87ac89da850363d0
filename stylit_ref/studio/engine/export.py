"""Write a picture, what it was made of, and how to make it again."""

from pathlib import Path
from shutil import rmtree

from stylit_ref.files.disk.whole_file import write_text
from stylit_ref.files.field import Field
from stylit_ref.files.nnf_file import write_nnf
from stylit_ref.files.realtime_field import write_realtime_field
from stylit_ref.files.write_image import write_image
from stylit_ref.studio.engine.command_lines import command_lines
from stylit_ref.studio.engine.events import Exported
from stylit_ref.studio.engine.scene import Buffers
from stylit_ref.studio.engine.shown import Shown

PICTURE, STYLE, NNF, COMMANDS = "picture.png", "style.png", "nnf.npy", "commands.sh"


def export(shown: Shown, folder: Path) -> Exported:
    """Write a picture, the style, the NNF and the command lines that give the same bytes.

    A scene that is in memory alone is written too. A failure leaves no new folder.

    Parameters
    ----------
    shown : Shown
    folder : Path
        Is made, if need be. Files of these names are replaced.

    Returns
    -------
    Exported

    Raises
    ------
    InputError
        If a file cannot be written.
    """
    is_new = not folder.exists()
    try:
        return _written(shown, folder)
    except BaseException:
        if is_new:
            rmtree(folder, ignore_errors=True)
        raise


def _written(shown: Shown, folder: Path) -> Exported:
    files = [PICTURE, STYLE, NNF]
    write_image(folder / PICTURE, shown.image)
    write_image(folder / STYLE, shown.style)
    if isinstance(shown.field, Field):
        write_nnf(folder / NNF, shown.field)
    else:
        write_realtime_field(folder / NNF, shown.field)
    scene = shown.scene
    if scene.files:
        guides = list(zip(scene.files.source, scene.files.targets[shown.step], strict=True))
    else:
        sides = {"source": scene.source, "target": scene.target(shown.step)}
        names = [_write_side(buffers, folder, side) for side, buffers in sides.items()]
        files += [name for side in names for name in side]
        guides = [(str(folder / source), str(folder / target))
                  for source, target in zip(*names, strict=True)]  # fmt: skip
    commands = command_lines(shown, guides, style=folder / STYLE, nnf=folder / NNF)
    write_text(folder / COMMANDS, "".join(f"{line}\n" for line in commands))
    return Exported(str(folder.resolve()), (*files, COMMANDS), commands)


def _write_side(buffers: Buffers, folder: Path, side: str) -> list[str]:
    names = [f"{side}/{name}.png" for name in buffers]
    for name, image in zip(names, buffers.values(), strict=True):
        write_image(folder / name, image)
    return names
