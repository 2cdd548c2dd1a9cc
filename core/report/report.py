"""The HTML report of oriented photographs, written card by card, so that ten thousand need no memory for pictures."""

from __future__ import annotations

from ..base.status import STATUSES
from ..figures.stations import Station, stations_svg
from .audit import reading_of
from .card import origin_words, photo_card
from .collection import CardPages, index_body, navigation, picture_file, range_of, thumbnail_of
from .compass import compass_panel
from .facts import status_word, summarise
from .overview import bar, overview_table, switches
from .page import DEFAULT_SOFTWARE, Frame, PageWriter
from .pieces import Html, fill, joined


class ReportWriter(PageWriter):
    """Write a report photo by photo; see `PageWriter` for the parameters and the use as a context manager.

    Up to `collection.MOST_ON_ONE_PAGE` photographs are cards on one page. Beyond that the page becomes an index, and
    the cards go to pages of their own in a folder beside it.

    Parameters
    ----------
    document, title, parameters, software, created, say
        As for `PageWriter`.
    expected_photos : int
        Number of photographs expected, which determines how far pictures are reduced.
    """

    # parameters: those of `PageWriter`, and one of its own
    def __init__(
        self,
        document,
        title,
        parameters=None,
        *,
        software=DEFAULT_SOFTWARE,
        created=None,
        expected_photos=0,
        say=str,
    ):
        super().__init__(document, title, parameters, software=software, created=created, say=say)
        self._picture_px = picture_width_px(expected_photos)
        self._photos, self._readings, self._pages = [], [], CardPages()

    def add(self, photo, extras=None, panels=None):
        """Append the card of a photograph.

        Parameters
        ----------
        photo : OrientedPhoto
        extras : mapping or None
            Further labels and values.
        panels : uint8 (h, w, 3) array or None
            Figure of the direction of view and the ground in view.
        """
        summary, number = summarise(photo), len(self._photos) + 1
        self._photos.append((summary, _station(photo, summary, number), origin_words(photo)))
        self._readings += filter(None, [reading_of(photo)])
        card = photo_card(photo, number, extras, self._picture_px, panels, self._say)
        self._document.write(card)
        self._pages.add(card, thumbnail_of(photo))
        self._put_pages()

    def _put_pages(self, last=False):
        """Move complete pages of cards to files of their own, if the report has too many cards for one page."""
        while self._pages.many and (taken := self._pages.take(last)):
            page, picture = taken
            say, summaries = self._say, self._summaries()[page.first - 1 : page.last]
            links = navigation(page, self._pages.more, self._document.home, say)
            table = overview_table(summaries, say, page.first)
            title = f"{self._title}: {range_of(page, say)}"
            frame = Frame(switches(), bar(summaries, say), joined([links, table]), links, title)
            head, tail = self._around(frame, self._counts(summaries))
            cards = self._document.cut(page.last - page.first + 1)
            self._document.add(page.html, head.encode("utf-8") + cards + tail.encode("utf-8"))
            if picture is not None:
                self._document.add(page.picture, picture_file(picture))

    def _summaries(self):
        return [summary for summary, _, _ in self._photos]

    def _counts(self, summaries=None):
        counted = self._summaries() if summaries is None else summaries
        counts = [(sum(summary.status == name for summary in counted), name) for name in STATUSES]
        return [f"{count} {status_word(name, self._say)}" for count, name in counts if count]

    def _frame(self):
        if self._pages.many:
            self._put_pages(last=True)
            body = index_body(self._photos, self._pages, self._document.folder, self._say)
            return Frame(overview=joined([compass_panel(self._readings, self._say), body]), name="index")
        summaries = self._summaries()
        table = overview_table(summaries, self._say)
        return Frame(
            switches(),
            bar(summaries, self._say),
            joined([table, self._plan(), compass_panel(self._readings, self._say)]),
        )

    def _plan(self):
        """Draw the collapsible plan of the stations."""
        say = self._say
        plan = stations_svg([station for _, station, _ in self._photos], say=say)
        title = say("Camera positions and headings")
        return fill("panel", title=title, body=Html(plan)) if plan else Html()


def _station(photo, summary, number):
    where = photo.longitude_deg, photo.latitude_deg
    return Station(
        *where, summary.name, summary.status, summary.heading_deg, summary.hfov_deg, anchor=f"photo-{number}"
    )


def picture_width_px(photos):
    """Width to which pictures are reduced in a report of this many photographs [pixels]."""
    return 1200 if photos <= 150 else 800 if photos <= 600 else 480
