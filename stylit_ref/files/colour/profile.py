"""What a file says of its colours: an ICC profile, a gamma, primaries.

Values are stylized as they are: no profile is applied to them. So what the style says of its
colours holds for the result, and goes into every file that can say it. Of a file that says nothing,
integers are taken as sRGB, and floating point as linear light with sRGB's primaries.
"""

import logging
import struct
import zlib
from pathlib import Path
from typing import NamedTuple

import numpy as np
import OpenImageIO as oiio

from stylit_ref.files.disk.image_file import open_image
from stylit_ref.files.disk.paths import split_layer
from stylit_ref.files.disk.png_chunks import read_chunks, replace_chunks
from stylit_ref.notes import note

SRGB_PRIMARIES = 0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329
"""x and y of red, green, blue and white."""

_SRGB_GAMMA = 1 / 0.45455

_PNG_COLOURS = b"cICP", b"iCCP", b"sRGB", b"gAMA", b"cHRM"
"""The first of them that a PNG file has counts, and the last two together."""


class ColourProfile(NamedTuple):
    """What a file says of its colours, where it is not what is assumed.

    Attributes
    ----------
    of_light : bool
        Whether the values are floating point, which is taken as scene-linear light.
    icc : bytes or None
        An ICC profile.
    icc_name : str
        What it calls itself.
    cicp : tuple of int or None
        The four code points of ITU-T H.273.
    gamma : float or None
        The exponent that turns values into light.
    primaries : tuple of float or None
        x and y of red, green, blue and white.
    """

    of_light: bool
    icc: bytes | None = None
    icc_name: str = ""
    cicp: tuple[int, ...] | None = None
    gamma: float | None = None
    primaries: tuple[float, ...] | None = None


def read_colour_profile(path: str | Path) -> ColourProfile:
    """Read what a file says of its colours.

    Parameters
    ----------
    path : str or Path
        A file, or ``file:LAYER``; what a file says holds for all its layers.

    Returns
    -------
    ColourProfile
        An ICC profile that is damaged or for other channels is left out, with a note.

    Raises
    ------
    InputError
        If the file is missing or cannot be read.
    """
    file, _ = split_layer(path)
    image = open_image(file)
    spec = image.spec()
    image.close()
    chunks = read_chunks(file)
    icc, primaries = spec.getattribute("ICCProfile"), spec.getattribute("chromaticities")
    icc = None if icc is None else np.asarray(icc, np.uint8).tobytes()
    if icc and not _fits(icc, spec.nchannels):
        note(f"{file}: its ICC profile is damaged or not one for its channels; it is left out")
        icc = None
    gamma = None
    if chunks.keys().isdisjoint(_PNG_COLOURS[:3]):
        if any(chunks.get(b"gAMA", b"")):
            gamma = 1e5 / int.from_bytes(chunks[b"gAMA"], "big")
        if len(chunks.get(b"cHRM", b"")) == 32:
            white, *others = np.reshape(struct.unpack(">8I", chunks[b"cHRM"]), (4, 2)) / 1e5
            primaries = np.ravel([*others, white])
    return ColourProfile(
        of_light=str(spec.format) in ("half", "float", "double"),
        icc=icc,
        icc_name=spec.get_string_attribute("ICCProfile:profile_description") if icc else "",
        cicp=spec.getattribute("CICP"),
        gamma=None if _same(gamma, _SRGB_GAMMA) else gamma,
        primaries=None
        if primaries is None or _same(primaries, SRGB_PRIMARIES)
        else tuple(map(float, primaries)),
    )


def for_values(profile: ColourProfile, of_light: bool) -> ColourProfile:
    """What a profile still says when its values have gone through the sRGB curve, or back.

    Only the primaries outlive that.
    """
    if profile.of_light == of_light:
        return profile
    return ColourProfile(of_light, primaries=profile.primaries)


def add_to_spec(profile: ColourProfile, spec: oiio.ImageSpec) -> None:
    """Describe the colours of a file that OpenImageIO is about to write."""
    if _fits(profile.icc, spec.nchannels):
        icc = np.frombuffer(profile.icc, np.uint8)
        spec.attribute("ICCProfile", oiio.TypeDesc(f"uint8[{icc.size}]"), icc)
    if profile.cicp:
        spec.attribute("CICP", oiio.TypeDesc("int[4]"), profile.cicp)
    if profile.primaries:
        spec.attribute("chromaticities", oiio.TypeDesc("float[8]"), profile.primaries)


def add_to_png(profile: ColourProfile, file: Path) -> None:
    """Describe the colours of a PNG file in place of OpenImageIO, which always writes sRGB's.

    It would also refuse to write a file at all whose ICC profile it dislikes.
    """
    chunks = {}
    if profile.icc:
        chunks[b"iCCP"] = b"ICC profile\0\0" + zlib.compress(profile.icc)
    if profile.cicp:
        chunks[b"cICP"] = bytes(profile.cicp)
    red_to_white = np.reshape(profile.primaries or SRGB_PRIMARIES, (4, 2))
    # PNG has no negative numbers, which wide spaces of light need.
    if (profile.gamma or profile.primaries) and (red_to_white >= 0).all():
        white_first = np.rint(1e5 * np.roll(red_to_white, 1, axis=0)).astype(int)
        chunks[b"gAMA"] = struct.pack(">I", round(1e5 / (profile.gamma or _SRGB_GAMMA)))
        chunks[b"cHRM"] = struct.pack(">8I", *white_first.flat)
    if chunks:
        replace_chunks(file, _PNG_COLOURS, chunks)


def differences(profile: ColourProfile, other: ColourProfile) -> list[str]:
    """Names of what two files say differently of their colours.

    An ICC profile of sRGB says what is assumed where there is none.
    """
    named = next((each.icc_name for each in (profile, other) if each.icc_name), None)
    found = {
        f"ICC profile {named!r}" if named else "ICC profile": _own_icc(profile) != _own_icc(other),
        "CICP code points": profile.cicp != other.cicp,
        f"gamma of {profile.gamma or other.gamma or 0:.3g}": not _same(profile.gamma, other.gamma),
        "primaries": not _same(profile.primaries, other.primaries),
    }
    return [name for name, differs in found.items() if differs]


def note_what_is_lost(profile: ColourProfile, path: str | Path, written: ColourProfile) -> None:
    """A note if a file says less of its colours than the profile that was meant for it."""
    lost = differences(profile, written)
    if lost:
        what, keeps = " and ".join(lost), "an .exr" if profile.of_light else "a .png"
        note(
            f"{path}: cannot hold the {what} of the picture, so its colours are taken as sRGB; "
            f"{keeps} file can",
            level=logging.WARNING,
        )


def note_another_profile(fill: str | Path, profile: ColourProfile) -> None:
    """A note if the colours of a fill will not look as they do in its own file.

    Parameters
    ----------
    fill : str or Path
    profile : ColourProfile
        Of the style, and so of the picture.
    """
    other = for_values(read_colour_profile(fill), profile.of_light)
    if differences(profile, other):
        what = " and ".join(differences(profile, other))
        note(
            f"{fill}: does not agree with the style in its {what}, so its colours will look "
            "different in the picture; convert it to the colour profile of the style",
            level=logging.WARNING,
        )


def _own_icc(profile):
    return None if "srgb" in profile.icc_name.lower() else profile.icc


def _same(a, b):
    """Whether numbers agree as closely as files store them; nothing is only the same as nothing."""
    if a is None or b is None:
        return a is b
    return np.allclose(a, b, rtol=0, atol=1e-3)


def _fits(icc, channels):
    """Whether bytes are an ICC profile for images of so many channels."""
    space = b"GRAY" if channels < 3 else b"RGB "
    return (
        icc is not None
        and icc[36:40] == b"acsp"
        and int.from_bytes(icc[:4], "big") == len(icc)
        and icc[16:20] == space
    )
