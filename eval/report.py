"""Report pages: Markdown for reading in the repository, HTML for the browser."""

from pathlib import Path

from markdown_it import MarkdownIt

from eval.circumstances import circumstances
from stylit_ref.files.output_file import write_text

REPORTS = Path("reports")

_PAGE = """<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>
body {{ font: 16px/1.5 sans-serif; max-width: 75rem; margin: 2rem auto; padding: 0 1rem }}
img {{ max-width: 100%; cursor: zoom-in }}
img.large {{ max-width: none; cursor: zoom-out }}
p:has(img), div.table {{ overflow-x: auto }}
table {{ border-collapse: collapse; font-size: .85em }}
th, td {{ border-bottom: 1px solid #ccc; padding: .2rem .6rem; text-align: right }}
th:first-child, td:first-child {{ text-align: left }}
</style>
{body}
<script>
document.addEventListener("click", event => {{
  if (event.target.tagName === "IMG") event.target.classList.toggle("large");
}});
</script>
</html>
"""


def html_page(title, text):
    """A page for the browser, readable on a phone; images enlarge when they are clicked.

    Parameters
    ----------
    title, text : str
        The text in Markdown.

    Returns
    -------
    str
    """
    body = MarkdownIt("commonmark").enable("table").render(text)
    body = body.replace("<table>", '<div class="table"><table>').replace(
        "</table>", "</table></div>"
    )
    return _PAGE.format(title=title, body=body)


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
    write_text(folder / "report.md", text)
    write_text(folder / "report.html", html_page(title, text))


def table(frame):
    """A data frame as a Markdown table; each column says its own format."""
    return frame.to_markdown(index=False, disable_numparse=True)
