"""Determine a picture's format from its first bytes, because the file name may be wrong."""

from __future__ import annotations

import os

from ..base.errors import UnreadablePhotoError
from ..base.messages import Message
from ..base.optional import available
from .tiff_pages import check_first_page

PHOTO_SUFFIXES = (".jpg", ".jpeg", ".jpe", ".jfif", ".heic", ".heif", ".hif")
"""Suffixes of the files that `list_photos` takes for photographs, in upper or lower case."""

GDAL_DRIVERS = {"jpeg": "JPEG", "heif": "HEIF", "png": "PNG", "tiff": "GTiff", "webp": "WEBP"}

HEIF_BRANDS = (b"heic", b"heix", b"heim", b"heis", b"hevc", b"hevx", b"mif1", b"msf1", b"mif2")
"""Major or compatible brands of an ISO 23008-12 file with HEVC pictures."""

MAX_PIXELS = 250_000_000
"""Larger pictures are refused by their header, before any pixel is decoded. The limit admits phones with 200 megapixels
and excludes decompression bombs."""


def format_of(path):
    """Determine 'jpeg', 'heif', 'png', 'tiff' or 'webp' from a file's content.

    Raises
    ------
    UnreadablePhotoError
        If the file is missing, not a regular file, empty, or in none of these formats.
    """
    head = _first_bytes(path)
    if not head:
        raise UnreadablePhotoError(path, Message("the file is empty. Copy it again from its source."))
    if head.startswith(b"\xff\xd8\xff"):
        return "jpeg"
    if head[4:8] == b"ftyp" and _is_heif(head):
        if not is_whole(path, empty_allowed=available("pillow_heif") is not None):
            raise UnreadablePhotoError(
                path, Message("it ends too early or its directory is damaged. Copy it again from its source.")
            )
        return "heif"
    if head.startswith(b"\x89PNG\r\n\x1a\n"):
        return "png"
    if head[:4] in (b"II*\0", b"MM\0*", b"II+\0", b"MM\0+"):
        check_first_page(path)
        return "tiff"
    if head[:4] == b"RIFF" and head[8:12] == b"WEBP":
        return "webp"
    raise UnreadablePhotoError(
        path, Message("its content is not a JPEG, HEIC, PNG, TIFF or WebP picture. Export it as JPEG.")
    )


def check_size(path, width_px, height_px):
    """Refuse pictures without pixels or with more than `MAX_PIXELS`.

    Parameters
    ----------
    path : str
        Path of the picture, for the error message.
    width_px, height_px : int
        Size of the picture, as stored or upright [pixels].

    Raises
    ------
    UnreadablePhotoError
    """
    if width_px < 1 or height_px < 1:
        raise UnreadablePhotoError(path, Message("it has no pixels. Copy it again from its source."))
    if width_px * height_px > MAX_PIXELS:
        raise UnreadablePhotoError(
            path,
            Message(
                "its {width} x {height} pixels are more than {limit} megapixels. Reduce its size first.",
                width=width_px,
                height=height_px,
                limit=MAX_PIXELS // 1_000_000,
            ),
        )


def _first_bytes(path, count=64):
    try:
        if os.path.exists(path) and not os.path.isfile(path):  # reading from a pipe could block for ever
            raise UnreadablePhotoError(path, Message("it is a folder or a device, not a file. Check the path."))
        with open(path, "rb") as file:
            return file.read(count)
    except FileNotFoundError:
        raise UnreadablePhotoError(path, Message("there is no such file. Check the path.")) from None
    except (OSError, ValueError) as error:  # ValueError: a null character in the path
        reason = getattr(error, "strerror", None) or str(error)
        raise UnreadablePhotoError(
            path, Message("it cannot be opened ({reason}). Check the path and the permissions.", reason=reason)
        ) from None


def _is_heif(head):
    size = min(int.from_bytes(head[:4], "big"), len(head))
    brands = [head[8:12], *(head[start : start + 4] for start in range(16, size - 3, 4))]
    return any(brand in HEIF_BRANDS for brand in brands)


def is_photo_name(name):
    """Tell whether a file name is that of a photograph; hidden files, as macOS's `._` companions, are not."""
    return not name.startswith(".") and os.path.splitext(name)[1].lower() in PHOTO_SUFFIXES


MAX_BOXES = 10_000
"""Largest number of top-level boxes that is read; a photograph has about five, a hostile file millions."""

MAX_DIRECTORY_BYTES = 64 * 2**20


def is_whole(path, empty_allowed=True):
    """Tell whether the boxes of directory and pixels and all extents of the items of a HEIF file end within the file.

    Parameters
    ----------
    path : str
    empty_allowed : bool
        Whether extents of no bytes are accepted. The standard allows such items, but they crash GDAL's reader.
    """
    size = os.path.getsize(path)
    directory = None
    with open(path, "rb") as file:
        for start, header, length, kind in _top_boxes(file, size):
            if kind not in (b"meta", b"mdat"):
                continue
            if start + length > size:
                return False
            if kind == b"meta" and directory is None and length <= MAX_DIRECTORY_BYTES:
                file.seek(start + header)
                directory = file.read(length - header)
    return directory is not None and _extents_fit(directory, size, empty_allowed)


def _top_boxes(file, size):
    """Yield (start, length of the header, length, kind) of the top-level boxes of the file."""
    start = 0
    for _ in range(MAX_BOXES):
        file.seek(start)
        head = file.read(16)
        if len(head) < 8:
            return
        length, header, kind = int.from_bytes(head[:4], "big"), 8, head[4:8]
        if length == 1:  # the true length follows in 64 bits
            length, header = int.from_bytes(head[8:16], "big"), 16
        elif length == 0:  # to the end of the file
            length = size - start
        if length < header:
            return  # data that a manufacturer appends
        yield start, header, length, kind
        start += length
        if start >= size:
            return


def _extents_fit(directory, file_size, empty_allowed):
    """Check the ItemLocationBox of a `meta` box's content against the sizes of the file and of its own data box."""
    try:
        children = dict(_children(directory))
        for method, offset, length in _extents(children[b"iloc"]):
            room = {0: file_size, 1: len(children.get(b"idat", b""))}.get(method)
            if room is not None and offset + length > room or not (length or empty_allowed):
                return False
    except (KeyError, ValueError):
        return False
    return True


def _children(directory):
    """Yield (kind, content) of the boxes inside a `meta` box's content, which begins with version and flags."""
    start = 4
    while start + 8 <= len(directory):
        length = int.from_bytes(directory[start : start + 4], "big") or len(directory) - start
        if length < 8 or start + length > len(directory):
            raise ValueError("a box reaches beyond its parent")
        yield directory[start + 4 : start + 8], directory[start + 8 : start + length]
        start += length


class _Fields:
    """Reader of successive big-endian integers in a byte string."""

    def __init__(self, content):
        self.content, self.place = content, 0

    def take(self, count):
        if self.place + count > len(self.content):
            raise ValueError("the box ends too early")
        value = int.from_bytes(self.content[self.place : self.place + count], "big")
        self.place += count
        return value


def _extents(content):
    """Yield (construction method, offset, length) of every extent in an ItemLocationBox."""
    fields = _Fields(content)
    version = fields.take(4) >> 24
    sizes = fields.take(2)
    offset_size, length_size, base_size, index_size = sizes >> 12, sizes >> 8 & 15, sizes >> 4 & 15, sizes & 15
    wide = 4 if version == 2 else 2
    for _ in range(fields.take(wide)):
        fields.take(wide)  # the item's number
        method = fields.take(2) & 15 if version in (1, 2) else 0
        fields.take(2)  # the data reference
        base = fields.take(base_size)
        for _ in range(fields.take(2)):
            if version in (1, 2):
                fields.take(index_size)
            yield method, base + fields.take(offset_size), fields.take(length_size)
