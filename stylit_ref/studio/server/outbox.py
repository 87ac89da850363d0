"""What waits to be sent to a page: texts in order, and of each kind of picture the newest."""

import asyncio
from collections import deque

from stylit_ref.studio.server.sent_picture import SentPicture

MOST_TEXTS = 1000
"""A page that reads so little loses the oldest."""


class Outbox:
    """Filled by the server, emptied by one task.

    A page that is slower than the engine gets fewer pictures, never old ones. Of a picture it is
    sent what has changed since the last one.
    """

    def __init__(self) -> None:
        self._texts: deque[str] = deque(maxlen=MOST_TEXTS)
        self._images: dict[str, bytes | SentPicture] = {}
        self._before: SentPicture | None = None
        self._filled = asyncio.Event()

    def say(self, text: str) -> None:
        """Send a text, before all pictures that wait."""
        self._texts.append(text)
        self._filled.set()

    def show(self, kind: str, image: bytes | SentPicture) -> None:
        """Send a picture, in place of one of its kind that still waits."""
        self._images.pop(kind, None)
        self._images[kind] = image
        self._filled.set()

    async def next(self) -> str | bytes:
        """What is to be sent now; waits until there is something."""
        await self._filled.wait()
        message = self._texts.popleft() if self._texts else self._oldest_image()
        if not (self._texts or self._images):
            self._filled.clear()
        return message

    def _oldest_image(self):
        image = self._images.pop(next(iter(self._images)))
        if not isinstance(image, SentPicture):
            return image
        message = image.message(self._before)
        self._before = image
        return message
