"""What a page sends in the body of a request: small JSON, with points of pictures in it."""

import json
from typing import Any

import numpy as np
from numpy.typing import NDArray
from starlette.exceptions import HTTPException
from starlette.requests import Request

_LARGEST = 64 * 2**10
_FARTHEST = 1e6


async def json_body(request: Request) -> dict[str, Any]:
    """The object that a request sends.

    Raises
    ------
    HTTPException
        If it sends something else.
    """
    content = await request.body()
    if len(content) > _LARGEST:
        raise HTTPException(413, "That is more than 64 KB.")
    try:
        said = json.loads(content)
    except (ValueError, RecursionError):
        said = None
    if not isinstance(said, dict):
        raise HTTPException(400, "The request does not say in JSON what it asks for.")
    return said


def points(said: dict[str, Any], name: str, count: int) -> NDArray[np.float64]:
    """Points ``[[x, y], ...]`` of an object.

    Raises
    ------
    HTTPException
        If they are no such points.
    """
    given = said.get(name)
    wrong = HTTPException(400, f"The request needs {name}: {count} times x and y.")
    if not (isinstance(given, list) and len(given) == count):
        raise wrong
    for point in given:
        if not (isinstance(point, list) and len(point) == 2 and all(map(_is_number, point))):
            raise wrong
    return np.array(given, np.float64)


def _is_number(value: object) -> bool:
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return is_number and -_FARTHEST < value < _FARTHEST
