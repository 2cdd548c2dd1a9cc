"""Find out from the directories of a TIFF file whether its first page is the photograph, or a thumbnail of it.

Raw files (DNG, NEF, CR2, ARW, ...) are TIFF files too. Their first page is usually a thumbnail, and the picture of the
sensor lies in a sub-directory, which neither Pillow nor GDAL decodes.
"""

from __future__ import annotations

import struct

from ..base.errors import UnreadablePhotoError
from ..base.messages import Message

SUBFILE, WIDTH, HEIGHT, PHOTOMETRIC, SUB_IFDS, DNG_VERSION = 254, 256, 257, 262, 330, 50706
SENSOR_COLOURS = (32803, 34892)
"""Values of PhotometricInterpretation for the colour filter array of a sensor, and for its linear values."""

MOST_DIRECTORIES, MOST_ENTRIES = 64, 1000
"""Limits for damaged files."""

SIZES = {1: "B", 3: "H", 4: "I", 13: "I", 16: "Q", 18: "Q"}
"""Integer types of TIFF, as `struct` calls them."""


def check_first_page(path):
    """Raise `UnreadablePhotoError` for a raw file, or if a further page of the TIFF is larger than the first."""
    pages = []
    try:
        with open(path, "rb") as file:
            pages = list(_directories(_Reader(file)))
    except (OSError, struct.error, OverflowError):
        pass  # a damaged directory is the decoder's concern
    if any(DNG_VERSION in page or page.get(PHOTOMETRIC, (0,))[0] in SENSOR_COLOURS for page in pages) or _is_cr2(path):
        raise UnreadablePhotoError(path, Message("it is a raw file of a camera, which must be exported as JPEG first."))
    sizes = [_size(page) for page in pages]
    largest = max(sizes, key=lambda size: size[0] * size[1], default=(0, 0))
    if sizes and largest[0] * largest[1] > sizes[0][0] * sizes[0][1]:
        raise UnreadablePhotoError(
            path,
            Message(
                "its first page of {width} x {height} pixels is a thumbnail of a larger picture. Export that as JPEG.",
                width=sizes[0][0],
                height=sizes[0][1],
            ),
        )


def _is_cr2(path):
    with open(path, "rb") as file:
        return file.read(10)[8:] == b"CR"


def _size(page):
    return page.get(WIDTH, (0,))[0], page.get(HEIGHT, (0,))[0]


class _Reader:
    """Reader of numbers in a TIFF file, classic or BigTIFF, in the byte order of the file."""

    def __init__(self, file):
        self.file = file
        head = file.read(4)
        self.order = "<" if head[:2] == b"II" else ">"
        self.big = 43 in head[2:]
        self.offset, self.count, self.entry = ("Q", "Q", 20) if self.big else ("I", "H", 12)
        self.first = self.at(8 if self.big else 4, self.offset)[0]

    def at(self, place, code, count=1):
        """Read `count` numbers of the `struct` type `code` at a place of the file.

        Parameters
        ----------
        place : int
            Offset in the file [bytes].
        code : str
        count : int
        """
        self.file.seek(place)
        form = f"{self.order}{count}{code}"
        return struct.unpack(form, self.file.read(struct.calcsize(form)))


def _directories(reader):
    """Yield each directory, sub-directories included, as a dict of its integer tags."""
    waiting = [reader.first]
    seen: set = set()
    while waiting and len(seen) < MOST_DIRECTORIES:
        place = waiting.pop(0)
        if place == 0 or place in seen:
            continue
        seen.add(place)
        page, following = _directory(reader, place)
        waiting += [following, *page.get(SUB_IFDS, ())]
        yield page


def _directory(reader, place):
    (count,) = reader.at(place, reader.count)
    start = place + struct.calcsize(reader.count)
    count, page = min(count, MOST_ENTRIES), {}
    for index in range(count):
        entry = start + index * reader.entry
        tag, kind = reader.at(entry, "H", 2)
        (values,) = reader.at(entry + 4, reader.offset)
        code, field = SIZES.get(kind), entry + 4 + struct.calcsize(reader.offset)
        if tag not in (SUBFILE, WIDTH, HEIGHT, PHOTOMETRIC, SUB_IFDS, DNG_VERSION) or code is None:
            continue
        values = min(values, MOST_DIRECTORIES)
        fits = values * struct.calcsize(code) <= struct.calcsize(reader.offset)
        page[tag] = reader.at(field if fits else reader.at(field, reader.offset)[0], code, values)
    (following,) = reader.at(start + count * reader.entry, reader.offset)
    return {tag: value for tag, value in page.items() if value}, following
