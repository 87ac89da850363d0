"""Report pages: Markdown for reading in the repository, HTML for the browser."""

from pathlib import Path

from markdown_it import MarkdownIt

from eval.circumstances import circumstances

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
