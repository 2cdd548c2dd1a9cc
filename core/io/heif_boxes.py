"""A look at an ISO media file's boxes before libheif sees them.

libheif fills the missing tiles of a truncated picture with something and says nothing; and under GDAL 3.6 libheif 1.15
ends the whole process where an item's extent is empty. So the directory is checked here.

References
----------
.. [1] ISO/IEC 14496-12, 4.2 (boxes) and 8.11.3 (ItemLocationBox).
"""

from __future__ import annotations

import os

MAX_BOXES = 10_000
"""A photograph's file has about five boxes at its top; more are an attack on our time."""

MAX_DIRECTORY_BYTES = 64 * 2**20


def is_whole(path, empty_allowed=True):
    """Tell whether the boxes of directory and pixels, and all extents of the items, end within the file.

    Parameters
    ----------
    path : str
    empty_allowed : bool
        Whether an extent of no bytes passes: the standard knows such items, GDAL's reader does not survive them.
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
    """Yield (start, length of the header, length, kind) of the boxes at the top of the file."""
    start = 0
    for _ in range(MAX_BOXES):
        file.seek(start)
        head = file.read(16)
        if len(head) < 8:
            return
        length, header, kind = int.from_bytes(head[:4], "big"), 8, head[4:8]
        if length == 1:  # the true length follows as 64 bit
            length, header = int.from_bytes(head[8:16], "big"), 16
        elif length == 0:  # to the end of the file
            length = size - start
        if length < header:
            return  # something that a maker appends
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
    """Big-endian integers from a byte string, one after the other."""

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
