"""How long a studio takes to start."""

import time

from eval.studio.server import serve

PAINTABLE = "window.stylitStudio?.session.painting && stylitStudio.artist.mayPaint"
"""Whether a page can be painted on."""

PICTURE = "window.stylitStudio?.result.which"
"""Which picture a page shows, if any."""

_IS_FAST = "window.stylitStudio?.result.which === 'fast'"


def start_times(browser, folder, kernels, *, fills=False):
    """Start a studio, and look when there is what.

    Parameters
    ----------
    browser : eval.studio.browser.Browser
        Is open already.
    folder : Path
        Of a new painting.
    kernels : Path
        Folder of compiled kernels.
    fills : bool
        Whether to wait until all kernels are compiled.

    Returns
    -------
    (float, float)
        Seconds from the command to a page that can be painted on, and to its first picture.
    """
    begun = time.perf_counter()
    with serve(folder, kernels) as server, browser.page(server.address) as page:
        page.until(PAINTABLE)
        paintable = time.perf_counter() - begun
        page.until(PICTURE)
        picture = time.perf_counter() - begun
        if fills:
            page.until(_IS_FAST)
    return paintable, picture
