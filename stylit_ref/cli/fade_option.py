"""The option of commands that fade one view into the next."""

from stylit_ref.cli.parser import Parser
from stylit_ref.views.interpolation.view_interpolator import BAND


def add_fade(parser: Parser) -> None:
    """Add ``--fade``; its value is called ``band``."""
    parser.add_argument(
        "--fade", type=float, default=BAND, metavar="SHARE", dest="band",
        help="how wide the fade is where the closest view changes, as a part of the way from view "
        "to view: 0 switches (default %(default)s)",
    )  # fmt: skip
