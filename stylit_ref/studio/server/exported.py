"""Files that were exported, to be saved from the page."""

from pathlib import Path

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import FileResponse
from starlette.routing import Route


def export_route(folder: Path) -> Route:
    """``/export/FILE``: what lies in the folder itself, and nothing that a link leads to.

    Parameters
    ----------
    folder : Path
    """

    def answer(request: Request) -> FileResponse:
        name = request.path_params["file"]
        files = {file.name: file for file in folder.iterdir()} if folder.is_dir() else {}
        file = files.get(name)
        if file is None or file.is_symlink() or not file.is_file():
            raise HTTPException(404, "There is no such exported file.")
        return FileResponse(file, filename=name)

    return Route("/export/{file}", answer)
