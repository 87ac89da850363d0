"""Report pages: Markdown for reading in the repository, HTML for the browser."""

import platform
import subprocess
from datetime import date
from pathlib import Path

import numba
from markdown_it import MarkdownIt

from stylit_ref import __version__

REPORTS = Path("reports")

_PAGE = """<!doctype html>
<meta charset="utf-8">
<title>{title}</title>
<style>
body {{ font: 16px/1.5 sans-serif; max-width: 75rem; margin: 2rem auto; padding: 0 1rem }}
img {{ max-width: 100% }}
table {{ border-collapse: collapse }}
th, td {{ border-bottom: 1px solid #ccc; padding: .2rem .8rem; text-align: right }}
</style>
{body}
"""


def circumstances():
    """One line that says which machine and which commit made a report."""
    return (
        f"stylit-ref {__version__}, commit {_COMMIT}; {_processor()}, "
        f"{numba.config.NUMBA_NUM_THREADS} threads; Python {platform.python_version()}, "
        f"numba {numba.__version__}; {date.today().isoformat()}"
    )


def write_report(folder, title, sections):
    """Write ``report.md`` and ``report.html``.

    Parameters
    ----------
    folder : Path
    title : str
    sections : iterable of str
        Markdown blocks.
    """
    text = "\n\n".join([f"# {title}", circumstances(), *sections]) + "\n"
    (folder / "report.md").write_text(text, encoding="utf-8")
    body = MarkdownIt("commonmark").enable("table").render(text)
    page = _PAGE.format(title=title, body=body)
    (folder / "report.html").write_text(page, encoding="utf-8")


def table(frame):
    """A data frame as a Markdown table; each column says its own format."""
    return frame.to_markdown(index=False, disable_numparse=True)


def _commit():
    """Commit of the checkout; reports themselves do not count as changes."""
    try:
        commit = _git("rev-parse", "--short", "HEAD")
        changed = _git("status", "--porcelain", "--untracked-files=no", "--", ".", ":!reports")
    except (OSError, subprocess.CalledProcessError):
        return "unknown"
    return f"{commit} with changes" if changed else commit


def _git(*arguments):
    """What git says of the checkout this file is in."""
    checkout = Path(__file__).parents[1]
    command = ["git", "-C", checkout, *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()


# Taken at the start: what is edited or committed during a long report did not make it.
_COMMIT = _commit()


def _processor():
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.partition(":")[2].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()
