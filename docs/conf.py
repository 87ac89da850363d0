"""The site, by ``make docs``; its source is the repository, so that pages stay where they are."""

import os
import re
from pathlib import Path

import numba
from sphinx.errors import ExtensionError

# Threads of notebooks sleep while they wait. sleep_while_waiting() would undo the line below.
os.environ.setdefault("GOMP_SPINCOUNT", "3000")
numba.config.DISABLE_JIT = True  # formulae as the functions they were written as, with docstrings

import stylit_ref  # noqa: E402
from stylit_ref.machine.code_digest import code_digest, imported_files  # noqa: E402


def _code_of_notebooks():
    """Identifies the code that notebooks call: outputs of another one are not taken."""
    notebooks = set(Path(__file__).parents[1].glob("notebooks/*.py"))
    return code_digest(*imported_files(*notebooks) - notebooks)[:16]


project = "stylit-ref"
author = copyright = "the stylit-ref developers"
release = stylit_ref.__version__
root_doc = "docs/index"

include_patterns = [
    "docs/**.md",
    "notebooks/*.py",
    "notebooks/README.md",
    "oracle/SPEC.md",
    "oracle/texture/SPEC.md",
    "oracle/realtime/SPEC.md",
    "oracle/views/SPEC.md",
    "oracle/interpolation/SPEC.md",
    "README.md",
    "CHANGELOG.md",
    "reports/README.md",
    "reports/*/report.md",
]
exclude_patterns = [".*", "build", "data_gen", "tests"]  # not looked into at all

extensions = ["myst_nb", "numpydoc", "sphinx.ext.autodoc", "sphinx.ext.viewcode"]
myst_enable_extensions = ["dollarmath", "amsmath", "html_image"]  # formulas; widths of pictures
myst_heading_anchors = 3
smartquotes = False  # a flag keeps its two dashes
numpydoc_show_class_members = False
autodoc_member_order = "bysource"

nb_custom_formats = {".py": ["jupytext.reads", {"fmt": "py:percent"}]}
nb_execution_mode = "cache"
nb_execution_cache_path = f"build/notebooks/{_code_of_notebooks()}"
nb_execution_timeout = 600
nb_execution_raise_on_error = True
nb_output_stderr = "warn"  # a warning fails the build

html_theme = "furo"
html_title = "stylit-ref"
# Formulae show without a network: this MathJax holds its fonts as outlines.
html_static_path = ["static", "../node_modules/mathjax/es5/tex-svg.js"]
html_css_files = ["site.css"]
mathjax_path = "tex-svg.js"
templates_path = ["templates"]
html_additional_pages = {"index": "redirect.html"}


_LINK_TO_CODE = re.compile(r"\]\((?![^)]*notebooks/)([^):]+\.py)\)")


def _download_code(app, page, text):
    """A link to a Python file is a download: MyST would look for a notebook."""
    text[0] = _LINK_TO_CODE.sub(r"](path:\1)", text[0])


def _skip_alias(app, kind, name, member, skip, options):
    """A named tuple's fields stand in its docstring."""
    return skip or (getattr(member, "__doc__", None) or "").startswith("Alias for field")


_FROM_A_NETWORK = re.compile(
    r"""<(?:script|link|img|source|iframe)\b[^>]*\b(?:src|href)=["']?(?:https?:)?//[^>]*>"""
    r"""|(?:url\(|@import)\s*["']?(?:https?:)?//[^\s)"']*"""
)


def _refuse_a_network(app, problem):
    """A page that loads something from elsewhere fails the build: the site is read offline too."""
    if problem is None and app.builder.name == "html":
        for file in (
            file for end in ("html", "css") for file in Path(app.outdir).rglob(f"*.{end}")
        ):
            found = _FROM_A_NETWORK.search(file.read_text(encoding="utf-8"))
            if found:
                raise ExtensionError(f"{file}: loads {found[0]} from a network")


def setup(app):
    """Called by Sphinx."""
    app.connect("autodoc-skip-member", _skip_alias)
    app.connect("source-read", _download_code)
    app.connect("build-finished", _refuse_a_network)
