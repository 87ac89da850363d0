"""Files that were exported, to be saved from the page."""

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import FileResponse
from starlette.routing import Route

from stylit_ref.studio.painting.folder import PaintingFolder


def export_route(painting: PaintingFolder) -> Route:
    """``/export/FILE``: what the last export has written, and nothing that a link leads to.

    Parameters
    ----------
    painting : PaintingFolder
    """

    def answer(request: Request) -> FileResponse:
        name, folder = request.path_params["file"], painting.exported()
        files = {file.name: file for file in folder.iterdir()} if folder.is_dir() else {}
        file = files.get(name)
        if file is None or file.is_symlink() or not file.is_file():
            raise HTTPException(404, "There is no such exported file.")
        return FileResponse(file, filename=name)

    return Route("/export/{file}", answer)
