"""The report of many photographs: an index with map, filters and thumbnails, and pages of cards beside it."""

from __future__ import annotations

import json
from dataclasses import dataclass
from urllib.parse import quote

import numpy as np

from ..base.errors import MissingPackageError
from ..base.status import STATUSES
from ..figures.raster import encode_jpeg, resized
from ..figures.stations import east_north
from ..figures.text import is_known, plain
from .facts import status_word
from .overview import SIGNS, columns, numbers_of, sort_key
from .pieces import Html, fill, joined

MOST_ON_ONE_PAGE = 200
"""Most photographs in a report of one page."""

MOST_BYTES_ON_ONE_PAGE = 45_000_000
"""Largest report of one page; browsers grow slow beyond, and mail refuses it."""

CARDS_A_PAGE, BYTES_A_PAGE = 50, 25_000_000
"""Most cards on a page of a large report, and where a page ends before."""

THUMBNAIL_PX, THUMBNAILS_A_ROW = (120, 90), 10
"""Width and height of a thumbnail's place in the picture that holds those of a page, and places side by side."""


@dataclass(frozen=True)
class CardPage:
    """A page of cards: its number, and those of its photographs, `first` to `last`; all from 1."""

    number: int
    first: int
    last: int

    @property
    def html(self):
        """Name of its file."""
        return f"page-{self.number:04d}.html"

    @property
    def picture(self):
        """Name of the file with its thumbnails."""
        return f"page-{self.number:04d}.jpg"


class CardPages:
    """Divides cards among pages in the order in which they come."""

    def __init__(self):
        self.pages, self.sizes = [], []
        self._waiting, self._thumbnails, self._total = [], [], 0

    def add(self, card, thumbnail):
        """Count a card (str) that was written, with its small picture or None."""
        size = len(card.encode("utf-8"))
        self._waiting.append(size)
        self._thumbnails.append(thumbnail)
        self._total += size
        self.sizes.append(None if thumbnail is None else thumbnail.shape[:2])

    @property
    def many(self):
        """Whether the cards are too many, or too large, for one page."""
        return len(self.sizes) > MOST_ON_ONE_PAGE or self._total > MOST_BYTES_ON_ONE_PAGE

    def take(self, last=False):
        """Take the next page that is complete, or the `last` cards.

        Returns
        -------
        (CardPage, picture) or None
            uint8 (h, w, 3) array of the thumbnails, or None if there are none.
        """
        fitting = np.cumsum(self._waiting[:CARDS_A_PAGE]) <= BYTES_A_PAGE
        count = max(int(fitting.sum()), 1)
        if not self._waiting or (count >= len(self._waiting) and not last):
            return None
        first = self.pages[-1].last + 1 if self.pages else 1
        page = CardPage(len(self.pages) + 1, first, first + min(count, len(self._waiting)) - 1)
        self.pages.append(page)
        thumbnails = self._thumbnails[:count]
        del self._waiting[:count], self._thumbnails[:count]
        return page, _sheet(thumbnails)

    @property
    def more(self):
        """Whether cards wait for a page."""
        return bool(self._waiting)


def thumbnail_of(photo):
    """Small picture of an `OrientedPhoto`, uint8 (h, w, 3), or None."""
    if photo.preview is None:
        return None
    pixels = photo.preview[..., :3]
    height, width = pixels.shape[:2]
    scale = min(THUMBNAIL_PX[0] / width, THUMBNAIL_PX[1] / height)
    try:
        return resized(pixels, max(round(width * scale), 1), max(round(height * scale), 1))
    except MissingPackageError:
        return None  # the card has said so


def picture_file(picture):
    """JPEG of a page's thumbnails."""
    return encode_jpeg(picture, 72)


def _sheet(thumbnails):
    """Put thumbnails side by side, row after row, each at the upper left of its place."""
    if not any(one is not None for one in thumbnails):
        return None
    width, height = THUMBNAIL_PX
    rows = -(-len(thumbnails) // THUMBNAILS_A_ROW)
    sheet = np.full((rows * height, THUMBNAILS_A_ROW * width, 3), 128, np.uint8)
    for place, one in enumerate(thumbnails):
        if one is not None:
            row, column = divmod(place, THUMBNAILS_A_ROW)
            sheet[row * height :, column * width :][: one.shape[0], : one.shape[1]] = one
    return sheet


def navigation(page, more, home, say=str):
    """Links from a page of cards to the index and to the pages beside it.

    Parameters
    ----------
    page : CardPage
    more : bool
        Whether another page follows.
    home : str
        Path of the index, from the page.
    say : callable
        Translates the fixed English words; see `core.figures.text`.
    """
    links = [(quote(home), say("All photographs"))]
    links += [(f"page-{page.number - 1:04d}.html", say("Previous page"))] if page.number > 1 else []
    links += [(f"page-{page.number + 1:04d}.html", say("Next page"))] if more else []
    return fill("navigation", links=_links(links))


def range_of(page, say=str):
    """Which photographs a page of cards shows, in words."""
    return say("photographs {first} to {last}").format(first=page.first, last=page.last)


def index_body(photos, pages, folder, say=str):
    """Map, filters and table of all photographs.

    Parameters
    ----------
    photos : sequence of (Summary, Station, str)
        Each with a line of text that is shown and searched too: when, and with which camera.
    pages : CardPages
    folder : str
        Folder of the pages, as the index refers to it.
    say : callable
        Translates the fixed English words; see `core.figures.text`.

    Returns
    -------
    Html
    """
    present = [name for name in STATUSES if any(summary.status == name for summary, _, _ in photos)]
    counts = {name: sum(summary.status == name for summary, _, _ in photos) for name in present}
    filters = joined(
        fill("index_filter", name=name, words=f"{SIGNS[name]} {status_word(name, say)} {counts[name]}")
        for name in present
    )
    heads = [fill("text_head", words=words) for words, _ in columns(say)]
    links = [(f"{quote(folder)}/{page.html}", f"{page.first}–{page.last}") for page in pages.pages]
    return fill(
        "index",
        filters=filters,
        heads=joined(heads),
        map=say("Camera positions and headings"),
        whole=say("whole map"),
        here=say("only this section of the map"),
        previous=say("Previous page"),
        next=say("Next page"),
        search=say("Search names, cameras, dates and reasons"),
        pages=fill("panel", title=say("Pages of cards"), body=fill("navigation", links=_links(links))),
        data=_data(photos, pages, quote(folder), say),
    )


def _links(links):
    return joined(fill("link", url=url, words=words) for url, words in links)


def _data(photos, pages, folder, say):
    """JSON of all photographs, safe inside a script element."""
    places = _places([station for _, station, _ in photos])
    page_of = [(page.number, first) for page in pages.pages for first in range(page.last - page.first + 1)]
    rows = []
    for index, (summary, station, origin) in enumerate(photos):
        numbers = numbers_of(summary, say)
        (sheet, cell), size, place = page_of[index], pages.sizes[index], places[index]
        rows.append(
            [
                STATUSES.index(summary.status),
                plain(summary.name),
                plain(origin),
                plain(summary.message) if summary.heading_deg is None else "",
                [sort_key(value) for value, _ in numbers],
                [words for _, words in numbers],
                None if place is None else [*place, _round(station.heading_deg), _round(station.hfov_deg)],
                [sheet, cell, *([0, 0] if size is None else [size[1], size[0]])],
            ]
        )  # fmt: skip
    facts = {
        "folder": folder,
        "statuses": [[name, f"{SIGNS[name]} {status_word(name, say)}"] for name in STATUSES],
        "place": [*THUMBNAIL_PX, THUMBNAILS_A_ROW],
        "found": say("{count} of {all} photographs"),
        "rows": say("{first} to {last}"),
        "photos": rows,
    }
    return Html(json.dumps(facts, separators=(",", ":")).replace("<", "\\u003c"))


def _places(stations):
    """Metres to the east and north of each station, rounded; None without a position."""
    known = [k for k, s in enumerate(stations) if is_known(s.longitude_deg) and is_known(s.latitude_deg)]
    places: list = [None] * len(stations)
    if known:
        for k, *place in zip(known, *east_north([stations[k] for k in known])):
            places[k] = [round(float(metres), 1) for metres in place]
    return places


def _round(value):
    return round(float(value), 1) if is_known(value) else None
