"""Who may talk to the server: the page that it has served to whoever has the token.

Any page of the Internet that is open in the same browser may send requests to this machine. What
they lack is the right ``Host`` (a name of theirs that leads here), the right ``Origin``, or the
cookie.
"""

import hmac
import secrets
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import NamedTuple
from urllib.parse import parse_qs

_SAFE = "GET", "HEAD"
"""Methods that change nothing; of these, browsers may leave out the origin."""


class Refusal(NamedTuple):
    """Why a request is refused: an HTTP status, and a sentence."""

    status: int
    sentence: str


@dataclass(frozen=True)
class Access:
    """The checks of one server.

    Attributes
    ----------
    port : int
    token : str
        What the printed address ends in.
    secret : str
        The value of the cookie, which no address ever shows.
    """

    port: int
    token: str = field(default_factory=lambda: secrets.token_urlsafe(32))
    secret: str = field(default_factory=lambda: secrets.token_urlsafe(32))

    @property
    def address(self) -> str:
        """What opens the page, token and all."""
        return f"http://127.0.0.1:{self.port}/?token={self.token}"

    @property
    def hosts(self) -> tuple[str, str]:
        """The two names of this machine, with the port."""
        return f"127.0.0.1:{self.port}", f"localhost:{self.port}"

    @property
    def cookie_name(self) -> str:
        """Cookies do not keep ports apart, so that of each server has a name of its own."""
        return f"stylit-studio-{self.port}"

    @property
    def cookie(self) -> str:
        """The header that sets the cookie.

        Browsers send it along where another place leads to the page, as the file does that opens
        it; whoever asks for a change is known by the origin.
        """
        return f"{self.cookie_name}={self.secret}; HttpOnly; SameSite=Lax; Path=/"

    def refusal(
        self, method: str, headers: Iterable[tuple[bytes, bytes]], *, is_socket: bool = False
    ) -> Refusal | None:
        """What is wrong with where a request comes from and goes to, token and cookie aside.

        Parameters
        ----------
        method : str
        headers : iterable of (bytes, bytes)
            Names in lower case, as ASGI has them.
        is_socket : bool
            Whether it opens a WebSocket, which browsers let any page do.

        Returns
        -------
        Refusal or None
        """
        named = _by_name(headers)
        hosts, origins = named.get(b"host", []), named.get(b"origin", [])
        if len(hosts) != 1 or hosts[0] not in self.hosts:
            return Refusal(403, f"The studio is at 127.0.0.1:{self.port}, under no other name.")
        if not is_socket and method not in ("GET", "HEAD", "POST"):
            return Refusal(405, "The studio knows GET and POST.")
        is_owed = is_socket or method not in _SAFE
        if (origins or is_owed) and origins != [f"http://{hosts[0]}"]:
            return Refusal(403, "This request does not come from the studio's own page.")
        return None

    def has_cookie(self, headers: Iterable[tuple[bytes, bytes]]) -> bool:
        """Whether one of the cookies is this server's."""
        sent = "; ".join(_by_name(headers).get(b"cookie", []))
        values = [
            value
            for name, _, value in (each.strip(" \t").partition("=") for each in sent.split(";"))
            if name == self.cookie_name
        ]
        return sum(_equal(value, self.secret) for value in values) > 0

    def has_token(self, query: bytes) -> bool:
        """Whether a query is ``token=`` and the right one, and says nothing else."""
        try:
            asked = parse_qs(query.decode("latin-1"), strict_parsing=True, max_num_fields=1)
        except ValueError:
            return False
        return list(asked) == ["token"] and _equal(asked["token"][0], self.token)


def _by_name(headers):
    named: dict[bytes, list[str]] = {}
    for name, value in headers:
        named.setdefault(name.lower(), []).append(value.decode("latin-1"))
    return named


def _equal(one, other):
    """Whether two texts are equal, in a time that does not tell where they differ."""
    return hmac.compare_digest(one.encode(), other.encode())
