"""Sizes and positions as words of a command line: x before y, as image editors show them."""

import argparse
import re


def size_of(text: str) -> tuple[int, int]:
    """Height and width of ``WIDTHxHEIGHT``; the ``type`` of an option."""
    found = re.fullmatch(r"(\d{1,9})[xX](\d{1,9})", text)
    if not found:
        raise argparse.ArgumentTypeError(f"is {text!r}; it must be WIDTHxHEIGHT, such as 1024x1024")
    width, height = map(int, found.groups())
    return height, width


def position_of(text: str) -> tuple[int, int]:
    """The y and x of ``X,Y``; the ``type`` of an option."""
    found = re.fullmatch(r"(\d{1,9}),(\d{1,9})", text)
    if not found:
        raise argparse.ArgumentTypeError(
            f"is {text!r}; it must be X,Y in pixels from the upper left corner, such as 120,80"
        )
    x, y = map(int, found.groups())
    return y, x
