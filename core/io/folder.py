"""Photographs of a folder, and what else it holds."""

from __future__ import annotations

import os
from collections import Counter

from ..base.errors import SkylineViewshedError
from ..base.messages import Message
from .formats import is_photo_name
from .photo import read_metadata

SOMETIMES = (".png", ".tif", ".tiff", ".webp", "")
"""Suffixes of files that count as photographs only if they record a position, since most of them are none."""


def scan_folder(folder, recursive=False):
    """List the photographs of a folder: JPEG and HEIC by their suffixes, others that record a position.

    Parameters
    ----------
    folder : str
    recursive : bool
        Whether folders in it are searched too.

    Returns
    -------
    photos : list of str
        Sorted paths.
    skipped : dict
        Number of the other files by suffix ('' for none); hidden files are not counted.

    Raises
    ------
    SkylineViewshedError
        If the folder is missing or cannot be read.
    """
    skipped: Counter[str] = Counter()
    found = []
    try:
        for entry in os.scandir(folder):
            if entry.is_file():
                if is_photo_name(entry.name) or _records_position(entry):
                    found.append(entry.path)
                elif not entry.name.startswith("."):
                    skipped[os.path.splitext(entry.name)[1].lower()] += 1
            elif recursive and entry.is_dir(follow_symlinks=False) and not entry.name.startswith("."):
                photos, others = scan_folder(entry.path, recursive=True)
                found += photos
                skipped.update(others)
    except OSError as error:
        raise SkylineViewshedError(
            Message(
                "The folder {folder} cannot be listed: {reason}. Check the path.", folder=folder, reason=error.strerror
            )
        ) from None
    return sorted(found), dict(sorted(skipped.items()))


def _records_position(entry):
    if entry.name.startswith(".") or os.path.splitext(entry.name)[1].lower() not in SOMETIMES:
        return False
    try:
        return read_metadata(entry.path).latitude_deg is not None
    except SkylineViewshedError:
        return False


def list_photos(folder, recursive=False):
    """List the photographs of a folder as `scan_folder` finds them.

    Raises
    ------
    SkylineViewshedError
        If the folder is missing or cannot be read.

    Examples
    --------
    >>> [os.path.basename(path) for path in list_photos(".")]
    ['north.jpg', 'west.jpg']
    """
    return scan_folder(folder, recursive)[0]
