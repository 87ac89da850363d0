"""Write reports: Markdown, a page for the browser, and a CSV for every table.

Every report has its own folder in ``build/reports``, and a failure leaves none half-written. The
report itself lists the files to commit; :mod:`eval.reports.publish` copies them.
"""

import json
import shutil
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from PIL import Image

from eval.pages.tables import table
from eval.pages.web_page import FEWEST_LISTED, headings, web_page

BUILT = Path("build/reports")
"""Folder of finished reports."""

COMMITTED = Path("reports")
"""Folder of the small, committed copies."""

RECORD = "report.json"
"""File in a report's folder that records its inputs, its files, and which of them to commit."""

_PARTIAL = ".partial_"

_QUALITY_OF_PAIRS = 85


class Report:
    """A report that is being written: its files, and the Markdown that shows them.

    Parameters
    ----------
    folder : Path
    """

    def __init__(self, folder):
        self.folder, self.files, self.committed = folder, [], []

    def figure(self, name, caption, draw, *arguments, committed=False):
        """Draw a figure to a file.

        Parameters
        ----------
        name, caption : str
        draw : callable
            Called with ``arguments``, then the file.
        committed : bool
            Whether the committed copy has this figure.

        Returns
        -------
        str
            Markdown that shows it.
        """
        file = f"{name}.webp"
        draw(*arguments, self.folder / file)
        self._add(file, committed)
        return f"![{caption}]({file})"

    def pair(self, name, one, other):
        """Write two images of a size, to be compared with a slider.

        Parameters
        ----------
        name : str
        one, other : (str, (H, W, 3) uint8)
            Title and image.

        Returns
        -------
        str
            Markdown that shows them.
        """
        shown = []
        for number, (title, image) in enumerate((one, other), 1):
            file = f"{name}_{number}.webp"
            Image.fromarray(image).save(self.folder / file, quality=_QUALITY_OF_PAIRS, method=6)
            self._add(file, True)
            shown.append(f"![{title}]({file})")
        return " ".join(shown)

    def table(self, name, numbers, shown):
        """Write a table's numbers as CSV; returns Markdown with its text."""
        return f"{table(shown)}\n\n{self.csv(name, numbers)}"

    def csv(self, name, numbers):
        """Write a table's numbers as CSV; returns Markdown that links them."""
        file = f"{name}.csv"
        numbers.to_csv(self.folder / file, index=False)
        self._add(file, True)
        return f"[{file}]({file})"

    def page(self, title, sections):
        """Write ``report.md``, and ``report.html`` with the figures embedded.

        Parameters
        ----------
        title : str
        sections : iterable of str
            Markdown blocks.
        """
        blocks = [f"# {title}", *sections]
        text = "\n\n".join(blocks) + "\n"
        page = web_page(title, text, self.folder)
        (self.folder / "report.html").write_text(page, encoding="utf-8")
        listed = headings(text)
        if len(listed) >= FEWEST_LISTED:
            contents = "\n".join(f"- [{name}](#{anchor})" for name, anchor in listed.items())
            text = "\n\n".join([blocks[0], contents, *blocks[1:]]) + "\n"
        (self.folder / "report.md").write_text(text, encoding="utf-8")
        self._add("report.md", True)
        self._add("report.html", False)

    def _add(self, file, committed):
        self.files.append(file)
        if committed:
            self.committed.append(file)


@contextmanager
def new_report(folder, inputs=None):
    """Make a report in a temporary folder; it replaces the last one when it is complete.

    Parameters
    ----------
    folder : Path
    inputs : str, optional
        Identifies everything that the report is made from (:func:`is_up_to_date`).

    Yields
    ------
    Report
    """
    folder.mkdir(parents=True, exist_ok=True)
    for killed in folder.glob(f"{_PARTIAL}*"):
        shutil.rmtree(killed)
    with TemporaryDirectory(prefix=_PARTIAL, dir=folder) as partial:
        report = Report(Path(partial))
        yield report
        write_record(report.folder, report.files, report.committed, inputs)
        for file in (*read_record(folder)["files"], RECORD):
            (folder / file).unlink(missing_ok=True)
        for file in (*report.files, RECORD):  # the record last: a report without it is made again
            (report.folder / file).replace(folder / file)


def write_record(folder, files, committed, inputs=None):
    """Write the record of a report."""
    record = {"inputs": inputs, "files": files, "committed": committed}
    (folder / RECORD).write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")


def read_record(folder):
    """The record of a report: ``inputs``, ``files``, ``committed``; empty if none can be read."""
    try:
        record = json.loads((folder / RECORD).read_text(encoding="utf-8"))
        names = {part: list(map(str, record[part])) for part in ("files", "committed")}
        if all(Path(name).name == name for part in names.values() for name in part):
            return {"inputs": record["inputs"], **names}
    except (OSError, ValueError, KeyError, TypeError):
        pass
    return {"inputs": None, "files": [], "committed": []}


def is_up_to_date(folder, inputs):
    """Whether the folder holds a complete report made from these inputs."""
    record = read_record(folder)
    return record["inputs"] == inputs and all((folder / file).exists() for file in record["files"])


def shown(folder):
    """Print a report and its path; returns the exit code."""
    print((folder / "report.md").read_text(encoding="utf-8"))
    print(f"Written: {folder / 'report.html'}")
    return 0
