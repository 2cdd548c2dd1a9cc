"""The HTML report of a run: written card by card, so that ten thousand photographs need no memory for their pictures.

The overview stands first and is known last; where the pieces wait meanwhile is the document's business:
`core.io.report_file.ReportFile` spools them to disk, `report_html` keeps them in a list.
"""

from __future__ import annotations

from typing import Protocol

from .draw_text import escape
from .report_card import photo_card
from .report_facts import STATUSES, summarise
from .report_overview import bar, overview_table, switches
from .report_page import page_head, page_tail, parameter_panel

MOST_ACCEPTED_WITH_FIGURES = 1_000
"""Accepted photographs drawn in full; browsers grow slow beyond some hundred megabytes. Later ones get numbers only."""

MOST_WITH_FIGURES = 2_000
"""All photographs drawn in full: the doubtful ones keep their pictures longer."""

DEFAULT_SOFTWARE = "Skyline Viewshed"


class Document(Protocol):
    """Where a page goes whose beginning is known last."""

    def write(self, text: str) -> None:
        """Append to the body."""

    def finish(self, head: str, tail: str) -> None:
        """Put `head` before the body and `tail` behind it, and make the whole appear."""

    def discard(self) -> None:
        """Leave nothing behind."""


class ReportWriter:
    """Write a report photo by photo.

    Used as a context manager the report appears whole at the end, and not at all after an error or a cancel.

    Parameters
    ----------
    document : Document
    title : str
    parameters : mapping or None
        Labels and values of the run; a mapping as value becomes a titled group ('DEM', 'Options').
    software : str
        Name and version of the program.
    created : datetime or None
        Printed under the title.
    expected_photos : int
        Decides how far pictures are reduced.
    """

    def __init__(self, document, title, parameters=None, *, software=DEFAULT_SOFTWARE, created=None, expected_photos=0):
        self._document, self._title, self._parameters = document, title, dict(parameters or {})
        self._software, self._created = software, created
        self._picture_px = picture_width_px(expected_photos)
        self._summaries, self._drawn, self._open = [], 0, True

    def __enter__(self):
        return self

    def __exit__(self, kind, value, traceback):
        if kind is None:
            self.close()
        else:
            self.discard()

    def add(self, photo, extras=None):
        """Append the card of an `OrientedPhoto`; `extras` maps further labels to values."""
        self._summaries.append(summarise(photo))
        most = MOST_ACCEPTED_WITH_FIGURES if photo.orientation.status == "accepted" else MOST_WITH_FIGURES
        figures = self._drawn < most
        self._drawn += figures
        self._document.write(photo_card(photo, len(self._summaries), extras, self._picture_px, figures))

    def close(self):
        """Finish the report and make it appear."""
        if not self._open:
            return
        self._open = False
        head = page_head(self._title) + switches() + self._mast() + bar(self._summaries) + '<div class="page">'
        head += parameter_panel(self._parameters) + overview_table(self._summaries)
        self._document.finish(head, self._left_out() + "</div>" + page_tail(self._software))

    def discard(self):
        """Give the report up, leaving nothing behind."""
        if self._open:
            self._open = False
            self._document.discard()

    def _mast(self):
        said = [f"{sum(s.status == name for s in self._summaries)} {name}" for name in STATUSES]
        said = [words for words in said if not words.startswith("0 ")]
        if self._created is not None:
            said.append(f"{self._created:%Y-%m-%d %H:%M}")
        said.append(self._software)
        counts = "".join(f"<span>{escape(words)}</span>" for words in said)
        return f'<div class="page-head"><h1>{escape(self._title)}</h1><div class="counts quiet">{counts}</div></div>\n'

    def _left_out(self):
        missing = len(self._summaries) - self._drawn
        if not missing:
            return ""
        return (
            f'<p class="panel">{missing} photographs have numbers but no figures here, to keep the page usable: a '
            f"report draws the first {MOST_WITH_FIGURES} in full ({MOST_ACCEPTED_WITH_FIGURES} accepted ones). "
            "Run them in smaller groups to see them all.</p>"
        )


def picture_width_px(photos):
    """Width to which pictures are reduced in a report of so many photographs [pixels]."""
    return 1200 if photos <= 150 else 800 if photos <= 600 else 480


def report_html(photos, title, parameters=None, *, software=DEFAULT_SOFTWARE, created=None):
    """Write the report of a handful of photographs as one text.

    Parameters
    ----------
    photos : sequence of OrientedPhoto
    title, parameters, software, created
        As for `ReportWriter`.

    Returns
    -------
    str
        A complete HTML page.
    """
    photos, document = list(photos), MemoryDocument()
    writer = ReportWriter(document, title, parameters, software=software, created=created, expected_photos=len(photos))
    with writer:
        for photo in photos:
            writer.add(photo)
    return document.text


class MemoryDocument:
    """A `Document` that ends as `text`."""

    def __init__(self):
        self._parts, self.text = [], ""

    def write(self, text):
        """See `Document`."""
        self._parts.append(text)

    def finish(self, head, tail):
        """See `Document`."""
        self.text = "".join([head, *self._parts, tail])

    def discard(self):
        """See `Document`."""
        self._parts.clear()
