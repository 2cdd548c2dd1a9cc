"""The fonts of pictures: a usual one, and for characters that it lacks any installed font that has them.

Pillow draws all text with one font and puts an empty box where a character is missing, so a text is split into runs.
"""

from __future__ import annotations

import os
import sys
import unicodedata
from functools import lru_cache

from ..base.errors import MissingPackageError
from ..base.messages import Message
from ..base.optional import require

_FONTS = {
    False: ("DejaVuSans.ttf", "Arial.ttf", "arial.ttf", "LiberationSans-Regular.ttf", "Helvetica.ttc"),
    True: ("DejaVuSans-Bold.ttf", "Arial Bold.ttf", "arialbd.ttf", "LiberationSans-Bold.ttf", "Helvetica.ttc"),
}
_WIDE_FONTS = (
    "notosanscjk", "notosans", "sourcehan", "msyh", "meiryo", "yugoth", "msgothic", "malgun", "simsun", "pingfang",
    "hiragino", "applesdgothic", "arial unicode", "arialuni", "nirmala", "mangal", "kohinoor", "lohit", "droidsans",
    "wqy", "leelawad", "tahoma", "segoeui", "gulim", "freesans", "unifont",
)  # fmt: skip
"""Beginnings of the names of files with upright sans-serif type for many scripts, which are tried first."""

_SAMPLE_PX = 20
_UNASSIGNED = "\U0002ffff"
"""A character that no font has; its picture is the box for missing ones."""


def usual_font(size_px, bold=False):
    """Font in which text is set as far as it has the characters.

    Raises
    ------
    MissingPackageError
        There is no font at all.
    """
    fonts = _image_font()
    for name in _FONTS[bold]:
        try:
            return fonts.truetype(name, round(size_px))
        except OSError:
            continue
    try:
        return fonts.load_default(round(size_px))
    except TypeError:  # before Pillow 10.1 the built-in font has one tiny size and no anchors
        raise MissingPackageError(
            Message(
                "Text in pictures needs a TrueType font, but none of DejaVu Sans, Arial, Liberation Sans or "
                "Helvetica is installed. Install one of them, for example with the package fonts-dejavu-core, or "
                "install a newer Pillow."
            )
        ) from None


def runs_of(words, size_px, bold=False):
    """Split text into runs of one font each.

    Parameters
    ----------
    words : str
    size_px : float
        Height of the type [pixels].
    bold : bool
        Applies to the usual font only.

    Returns
    -------
    list of (str, font)
    """
    usual = usual_font(size_px, bold)
    runs: list = []
    for character in words:
        # Spaces and marks stay with the letter before them.
        path = runs[-1][1] if runs and not _is_letter(character) else font_with(character)
        if runs and runs[-1][1] == path:
            runs[-1][0].append(character)
        else:
            runs.append(([character], path))
    fonts = _image_font()
    return [
        ("".join(letters), usual if not path else fonts.truetype(path, round(size_px))) for letters, path in runs
    ] or [("", usual)]


def missing_characters(words):
    """Characters of a text that no installed font has, each once, in order."""
    return "".join(dict.fromkeys(c for c in words if _is_letter(c) and font_with(c) is None))


def _is_letter(character):
    return unicodedata.category(character)[0] not in "ZMC"


@lru_cache(maxsize=4096)
def font_with(character):
    """Path of an installed font with a character; '' if the usual font has it, None if none has."""
    if character.isascii() or _has(usual_font(_SAMPLE_PX), character):
        return ""
    fonts = _image_font()
    for path in _installed():
        try:
            if _has(fonts.truetype(path, _SAMPLE_PX), character):
                return path
        except (OSError, ValueError):  # a damaged font, or a bitmap font without this size
            continue
    return None


def _has(font, character):
    shown, box = font.getmask(character), font.getmask(_UNASSIGNED)
    return shown.size != box.size or bytes(shown) != bytes(box)


@lru_cache(maxsize=1)
def _installed():
    """Paths of the fonts of this computer, those for many scripts first."""
    found = []
    for folder in _font_folders():
        for parent, _, names in os.walk(folder):
            found += [os.path.join(parent, n) for n in names if n.lower().endswith((".ttf", ".otf", ".ttc"))]
    return sorted(found, key=_preference)


def _preference(path):
    name = os.path.basename(path).lower()
    rank = next((k for k, start in enumerate(_WIDE_FONTS) if name.startswith(start)), len(_WIDE_FONTS))
    return rank, any(word in name for word in ("bold", "italic", "black", "light", "thin", "serif")), name


def _font_folders():
    home = os.path.expanduser("~")
    if sys.platform == "win32":
        own = os.path.join(os.environ.get("LOCALAPPDATA", home), "Microsoft", "Windows", "Fonts")
        return [os.path.join(os.environ.get("WINDIR", "C:\\Windows"), "Fonts"), own]
    if sys.platform == "darwin":
        return ["/System/Library/Fonts", "/Library/Fonts", os.path.join(home, "Library", "Fonts")]
    shares = os.environ.get("XDG_DATA_DIRS", "/usr/local/share:/usr/share").split(":")
    folders = [os.path.join(share, "fonts") for share in shares if share]
    return [*folders, os.path.join(home, ".fonts"), os.path.join(home, ".local", "share", "fonts")]


def _image_font():
    feature = Message("Drawing and writing pictures")
    require("PIL", feature)
    return require("PIL.ImageFont", feature)
