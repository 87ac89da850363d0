"""The viewer's page of a RUN, for the studio."""

from stylit_ref.viewer.contents import make_contents
from stylit_ref.viewer.of_run import views_of_page
from stylit_ref.viewer.write_page import page_bytes
from stylit_ref.views.interpolation.view_interpolator import BAND
from stylit_ref.views.run_folder import Run


def views_page(run: str) -> bytes:
    """The page, made before anybody paints: it keeps all processors busy for a while.

    Raises
    ------
    InputError
        If it is no finished RUN.
    """
    views = views_of_page(Run(run))
    return page_bytes(make_contents(views, title="Views", band=BAND))
