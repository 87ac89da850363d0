"""Copy finished reports to the folder of committed reports, with small and few figures.

A report's record lists what is committed: the page, the CSVs, and some of the figures.
"""

import io
import math
import re
import shutil

from PIL import Image

from eval.pages.page import BUILT, COMMITTED, RECORD, read_record
from stylit_ref import InputError

MOST_BYTES = 250_000
"""Most bytes of a committed figure."""

MOST_OF_COPY = {"lasram": 1_500_000, "heidrich": 1_000_000, "hauptfleisch": 2_000_000}
"""Most bytes of a committed copy, by the first word of its name; its largest figures give way."""

MOST_PIXELS = 2000
"""Width of a committed figure."""

_FIGURE = r"!\[[^\]]*\]\(([^)]*)\)"


def add_options(parser):
    """Declare what the command may be told."""
    parser.add_argument(
        "names", nargs="*", metavar="NAME",
        help=f"folders of {BUILT} to copy (default: those that have a committed copy already)",
    )  # fmt: skip


def main(options):
    """Copy the reports; returns the exit code."""
    for folder in publish(options.names):
        print(f"Written: {folder}")
    return 0


def publish(names=()):
    """Copy reports to the folder of committed reports.

    Parameters
    ----------
    names : sequence of str
        Folders of ``build/reports``; by default those that have a committed copy already.

    Returns
    -------
    list of Path
        The folders written.

    Raises
    ------
    InputError
        If a report is not finished, or there is none to copy.
    """
    names = names or sorted(
        folder.name for folder in COMMITTED.glob("*/") if (BUILT / folder.name / RECORD).exists()
    )
    if not names:
        raise InputError(f"{BUILT}: holds none of the committed reports; make one first")
    for name in names:
        if not (BUILT / name / RECORD).exists():
            raise InputError(
                f"{BUILT / name}: is not a finished report; make it with python -m eval"
            )
    return [_publish(BUILT / name, COMMITTED / name) for name in names]


def _publish(built, folder):
    """Replace the copy of a report."""
    files = read_record(built)["committed"]
    figures = [file for file in files if file.endswith(".webp")]
    rest = sum((built / file).stat().st_size for file in set(files) - set(figures))
    most = MOST_OF_COPY.get(folder.name.partition("_")[0], math.inf) - rest
    encoded = small_figures([built / file for file in figures], most)
    if folder.exists():
        shutil.rmtree(folder)
    folder.mkdir(parents=True)
    for file in files:
        if file in figures:
            (folder / file).write_bytes(encoded[file])
        elif file.endswith(".md"):
            text = (built / file).read_text(encoding="utf-8")
            (folder / file).write_text(only_figures(text, files), encoding="utf-8")
        else:
            shutil.copyfile(built / file, folder / file)
    return folder


def only_figures(text, files):
    """A page with only those figures that are among some files.

    Parameters
    ----------
    text : str
        Markdown; a figure, or a pair of them, is a paragraph of its own.
    files : sequence of str

    Returns
    -------
    str
    """
    return "\n\n".join(
        paragraph
        for paragraph in text.split("\n\n")
        if not re.fullmatch(rf"{_FIGURE}( {_FIGURE})?", paragraph)
        or set(re.findall(_FIGURE, paragraph)) <= set(files)
    )


def small_figures(files, most=math.inf):
    """Figures as WebP, none larger than :data:`MOST_BYTES`.

    Parameters
    ----------
    files : sequence of Path
    most : float
        Bytes of all together; if they are more, the largest become smaller.

    Returns
    -------
    dict of str to bytes
        By the name of the file.
    """
    bound = MOST_BYTES
    while True:
        encoded = {file.name: _small_figure(file, bound) for file in files}
        if sum(map(len, encoded.values())) <= most:
            return encoded
        bound = 3 * bound // 4


def _small_figure(file, most):
    """A figure as WebP of that many bytes at most; a small file stays as it is."""
    if file.suffix == ".webp" and file.stat().st_size <= most:
        return file.read_bytes()
    image = Image.open(file).convert("RGB")
    width = min(image.width, MOST_PIXELS)
    while True:
        scaled = image.resize((width, round(image.height * width / image.width)), Image.LANCZOS)
        for quality in (80, 65):  # lower quality blurs letters more than a smaller image does
            encoded = io.BytesIO()
            scaled.save(encoded, "WEBP", quality=quality, method=6)
            if encoded.tell() <= most:
                return encoded.getvalue()
        width = round(0.9 * width)
