"""What kind of picture a file holds, told by its first bytes; its name may lie."""

from __future__ import annotations

import os

from ..errors import UnreadablePhotoError
from ..optional import available
from .heif_boxes import is_whole

PHOTO_SUFFIXES = (".jpg", ".jpeg", ".jpe", ".jfif", ".heic", ".heif", ".hif")
"""Names that `list_photos` takes for photographs, in any case."""

GDAL_DRIVERS = {"jpeg": "JPEG", "heif": "HEIF", "png": "PNG", "tiff": "GTiff", "webp": "WEBP"}

HEIF_BRANDS = (b"heic", b"heix", b"heim", b"heis", b"hevc", b"hevx", b"mif1", b"msf1", b"mif2")
"""Major or compatible brands of an ISO 23008-12 file with HEVC pictures."""

MAX_PIXELS = 250_000_000
"""Larger pictures are refused by their header, before any pixel is decoded: 200 megapixel phones pass, bombs do not."""


def format_of(path):
    """Tell 'jpeg', 'heif', 'png', 'tiff' or 'webp' from a file's content.

    Raises
    ------
    UnreadablePhotoError
        Missing, not a file, empty, or none of these.
    """
    head = _first_bytes(path)
    if not head:
        raise UnreadablePhotoError(path, "the file is empty. Copy it again from its source.")
    if head.startswith(b"\xff\xd8\xff"):
        return "jpeg"
    if head[4:8] == b"ftyp" and _is_heif(head):
        if not is_whole(path, empty_allowed=available("pillow_heif") is not None):
            raise UnreadablePhotoError(
                path, "it ends too early or its directory is damaged. Copy it again from its source."
            )
        return "heif"
    if head.startswith(b"\x89PNG\r\n\x1a\n"):
        return "png"
    if head[:4] in (b"II*\0", b"MM\0*", b"II+\0", b"MM\0+"):
        return "tiff"
    if head[:4] == b"RIFF" and head[8:12] == b"WEBP":
        return "webp"
    raise UnreadablePhotoError(path, "its content is no JPEG, HEIC, PNG, TIFF or WebP picture. Export it as JPEG.")


def check_size(path, width_px, height_px):
    """Refuse pictures of no size or of more than `MAX_PIXELS`."""
    if width_px < 1 or height_px < 1:
        raise UnreadablePhotoError(path, "it has no pixels. Copy it again from its source.")
    if width_px * height_px > MAX_PIXELS:
        raise UnreadablePhotoError(
            path,
            f"its {width_px} x {height_px} pixels are more than {MAX_PIXELS // 1_000_000} megapixels. "
            "Reduce the picture first.",
        )


def _first_bytes(path, count=64):
    try:
        if os.path.exists(path) and not os.path.isfile(path):  # a pipe would keep us waiting for ever
            raise UnreadablePhotoError(path, "it is a folder or a device, not a file.")
        with open(path, "rb") as file:
            return file.read(count)
    except FileNotFoundError:
        raise UnreadablePhotoError(path, "there is no such file. Check the path.") from None
    except (OSError, ValueError) as error:  # ValueError: a null character in the path
        reason = getattr(error, "strerror", None) or str(error)
        raise UnreadablePhotoError(path, f"it cannot be opened ({reason}).") from None


def _is_heif(head):
    size = min(int.from_bytes(head[:4], "big"), len(head))
    brands = [head[8:12], *(head[start : start + 4] for start in range(16, size - 3, 4))]
    return any(brand in HEIF_BRANDS for brand in brands)


def is_photo_name(name):
    """Tell whether a file name looks like a photograph; macOS's `._` companions and hidden files do not."""
    return not name.startswith(".") and os.path.splitext(name)[1].lower() in PHOTO_SUFFIXES
