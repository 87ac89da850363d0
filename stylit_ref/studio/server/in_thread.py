"""Work for a thread, so that strokes need not wait for it."""

import asyncio
from collections.abc import Callable
from typing import TypeVar

from starlette.exceptions import HTTPException

from stylit_ref.errors import InputError
from stylit_ref.studio.server.protocol import sentence

Result = TypeVar("Result")


async def in_thread(work: Callable[[], Result]) -> Result:
    """What the work returns.

    Raises
    ------
    HTTPException
        With the sentence of an InputError.
    """
    try:
        return await asyncio.to_thread(work)
    except InputError as error:
        raise HTTPException(400, sentence(error)) from None
