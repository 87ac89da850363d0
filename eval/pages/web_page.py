"""Turn Markdown into one page for the browser, for phone and desktop, that needs no network.

A paragraph that is an image becomes a figure that a click or a key enlarges. A paragraph of two
images becomes a figure with a slider between them. Headings are listed at the side.
"""

import base64
import re
from html import escape
from pathlib import Path

from markdown_it import MarkdownIt

from eval.pages.claims import VERDICTS

FEWEST_LISTED = 4
"""A page of fewer headings has no contents list."""

STYLE, SCRIPT = (
    Path(__file__).with_name(f"reading.{kind}").read_text("utf-8") for kind in ("css", "js")
)
"""How every page looks and acts."""

_PAGE = """\
<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>
{style}</style>
<body class="{kind}">
{contents}<main>
{body}</main>
<dialog aria-label="Enlarged picture">
<p><button autofocus onclick="this.closest('dialog').close()">Close</button>
<button data-step="-1" aria-label="Previous picture">←</button>
<button data-step="1" aria-label="Next picture">→</button></p>
<div></div>
</dialog>
<script>
{script}</script>
</body>
</html>
"""

_IMAGE = r'<img src="([^"]*)" alt="([^"]*)" />'


def web_page(title, text, folder):
    """A page for the browser.

    Parameters
    ----------
    title, text : str
        ``text`` is Markdown.
    folder : Path
        Where the WebP images lie that it names; they are embedded.

    Returns
    -------
    str
    """
    found = headings(text)
    body = _with_anchors(MarkdownIt("commonmark").enable("table").render(text), found)
    for pattern, change in (
        (rf"<p>{_IMAGE}\s{_IMAGE}</p>", _compared),
        (rf"<p>{_IMAGE}</p>", _enlarged),
        (r"<table>.*?</table>", _scrolled),
        (rf"<td>({'|'.join(VERDICTS)})</td>", _marked),
    ):
        body = re.sub(pattern, change, body, flags=re.DOTALL)
    return _PAGE.format(
        title=escape(title),
        style=STYLE,
        script=SCRIPT,
        kind="listed" if len(found) >= FEWEST_LISTED else "",
        contents=_contents(found),
        body=re.sub(r'src="([^":]+\.webp)"', lambda match: _embedded(folder / match[1]), body),
    )


def headings(text):
    """The headings of the second rank of a Markdown text, and their anchors as GitHub makes them.

    Parameters
    ----------
    text : str

    Returns
    -------
    dict of str to str
        Anchor by heading.
    """
    found = re.findall(r"^## (.+)$", text, flags=re.MULTILINE)
    return {heading: re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in found}


def _with_anchors(body, found):
    for heading, anchor in found.items():
        title = MarkdownIt("commonmark").renderInline(heading)
        body = body.replace(f"<h2>{title}</h2>", f'<h2 id="{anchor}">{title}</h2>')
    return body


def _contents(found):
    if len(found) < FEWEST_LISTED:
        return ""
    lines = "\n".join(
        f'<li><a href="#{anchor}">{MarkdownIt("commonmark").renderInline(heading)}</a></li>'
        for heading, anchor in found.items()
    )
    return f"<nav><details><summary>Contents</summary>\n<ul>\n{lines}\n</ul></details></nav>\n"


def _enlarged(match):
    source, caption = match.groups()
    return (
        f'<figure><button class="enlarge" aria-label="Enlarge: {caption}">'
        f'<img src="{source}" alt="{caption}"></button><figcaption>{caption}</figcaption></figure>'
    )


def _compared(match):
    one, left, other, right = match.groups()
    return (
        f'<figure class="compare"><div class="pair"><img src="{one}" alt="{left}">'
        f'<img src="{other}" alt="{right}"></div><input type="range" min="0" max="100" value="50" '
        f'aria-label="Show {left} up to here, then {right}"><figcaption><span>{left}</span>'
        f'<button class="enlarge">Enlarge</button><span>{right}</span></figcaption></figure>'
    )


def _scrolled(match):
    """Tables scroll by themselves, also with the keyboard; words are not aligned as numbers are."""
    table = match[0]
    cells = re.findall(r"<td[^>]*>(.*?)</td>", table, flags=re.DOTALL)
    words = sum(len(cell) > 24 for cell in cells) > len(cells) / 8
    kind = "table words" if words else "table"
    table = re.sub(r' style="[^"]*"', "", table)
    return f'<div class="{kind}" tabindex="0">{table}</div>'


def _marked(match):
    """A verdict: its class is its words."""
    return f'<td class="{match[1].replace(" ", "-")}">{match[1]}</td>'


def _embedded(file):
    """The source of an image; one that moves is marked, for those who want no motion."""
    data = file.read_bytes()
    moves = " data-moves" if b"ANIM" in data[:64] else ""
    return f'src="data:image/webp;base64,{base64.b64encode(data).decode()}"{moves}'
