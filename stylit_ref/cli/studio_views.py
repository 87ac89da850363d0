"""The viewer's page of a RUN, for the studio."""

from collections.abc import Callable

from stylit_ref.viewer.contents import make_contents
from stylit_ref.viewer.of_run import views_of_page
from stylit_ref.viewer.write_page import page_bytes
from stylit_ref.views.interpolation.view_interpolator import BAND
from stylit_ref.views.run_folder import Run


def views_page(run: str) -> Callable[[], bytes]:
    """What makes the page of a RUN, whose files are checked now.

    Raises
    ------
    InputError
        If it is no finished RUN.
    """
    finished = Run(run)
    return lambda: page_bytes(make_contents(views_of_page(finished), title="Views", band=BAND))
