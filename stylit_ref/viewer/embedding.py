"""Bytes within the text of a page; ``src/embedding.ts`` takes them out again.

A page says that its encoding is windows-1252, in which each of the 256 bytes is a character of its
own. So a byte takes a byte, where base64 takes a third more.
"""

ESCAPE = b"="
_CHANGED = b"=\0\r<"
"""The escape itself; what HTML replaces; and where a tag may begin.

A line feed is not among them: where a program makes a carriage return and a line feed of it, HTML
makes a line feed of them again.
"""


def embedded(packed: bytes) -> str:
    """Bytes as characters that stay as they are within a script of a page.

    Parameters
    ----------
    packed : bytes

    Returns
    -------
    str
        Each character is a byte. In place of one that HTML may change there are ``=`` and the byte
        64 above it.
    """
    for byte in _CHANGED:  # the escape comes first
        packed = packed.replace(bytes([byte]), ESCAPE + bytes([byte + 64]))
    return packed.decode("latin-1")


def ascii_text(text: str) -> str:
    """A text for HTML; what is not ASCII is told by numbers, which no encoding changes."""
    return text.encode("ascii", "xmlcharrefreplace").decode()
