"""The port of this machine that the studio listens at."""

import errno
import socket

from stylit_ref.errors import InputError

USUAL_PORT = 8517
"""Where browsers may have a bookmark."""

_MORE = 20
"""Ports after the usual one that are tried."""


def open_door(port: int | None) -> socket.socket:
    """Listen at a port of 127.0.0.1, which no other machine can reach.

    Parameters
    ----------
    port : int or None
        0 for any that is free; None for the usual one, or the next that is free.

    Raises
    ------
    InputError
        If it is taken, or all of them are.
    """
    asked = range(USUAL_PORT, USUAL_PORT + _MORE) if port is None else [port]
    for each in asked:
        try:
            door = socket.create_server(("127.0.0.1", each))
            # Pages' sockets inherit it: else a picture may wait 40 ms until the one before has
            # been acknowledged. asyncio sets it on sockets that name their protocol; these do not.
            door.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            return door
        except OSError as error:
            reason = error
            if error.errno != errno.EADDRINUSE:
                break
    if reason.errno == errno.EADDRINUSE:
        sentence = f"is {asked[0]}, which another program listens at; leave it out for a free one"
    else:
        sentence = f"is {asked[0]}, which cannot be listened at: {reason.strerror}"
    raise InputError(sentence, parameter="port")


def port_of(door: socket.socket) -> int:
    """The number of the port that is listened at."""
    return door.getsockname()[1]
