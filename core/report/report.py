"""The HTML report of oriented photographs, written card by card, so that ten thousand need no memory for pictures."""

from __future__ import annotations

from ..base.status import RELIABLE, STATUSES
from ..figures.stations import Station, stations_svg
from .card import photo_card
from .facts import status_word, summarise
from .overview import bar, overview_table, switches
from .page import DEFAULT_SOFTWARE, PageWriter
from .pieces import Html, fill, joined, long_text

MOST_ACCEPTED_WITH_FIGURES = 1_000
"""Most accepted photographs drawn in full; browsers grow slow beyond some hundred megabytes. Later ones get numbers
only."""

MOST_WITH_FIGURES = 2_000
"""Most photographs drawn in full; the doubtful ones keep their pictures longer."""


MOST_ON_PLAN = 1_000


class ReportWriter(PageWriter):
    """Write a report photo by photo; see `PageWriter` for the parameters and the use as a context manager.

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
        self._summaries, self._stations, self._drawn = [], [], 0

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
        self._summaries.append(summarise(photo))
        self._stations.append(_station(photo, self._summaries[-1], len(self._summaries)))
        most = MOST_ACCEPTED_WITH_FIGURES if photo.orientation.status in RELIABLE else MOST_WITH_FIGURES
        figures = self._drawn < most
        self._drawn += figures
        number = len(self._summaries)
        self._document.write(photo_card(photo, number, extras, self._picture_px if figures else 0, panels, self._say))

    def _counts(self):
        counts = [(sum(summary.status == name for summary in self._summaries), name) for name in STATUSES]
        return [f"{count} {status_word(name, self._say)}" for count, name in counts if count]

    def _frame(self):
        table = overview_table(self._summaries, self._say)
        return (switches(), bar(self._summaries, self._say)), joined([table, self._plan()]), self._left_out()

    def _plan(self):
        """Draw the collapsible plan of the stations, at most the first thousand of them."""
        say = self._say
        plan = stations_svg(self._stations[:MOST_ON_PLAN], say=say)
        title = say("Camera positions and headings")
        return fill("panel", title=title, body=Html(plan)) if plan else Html()

    def _left_out(self):
        missing = len(self._summaries) - self._drawn
        if not missing:
            return ""
        say = self._say
        words = say(
            "{count} photographs are shown without figures, to keep this page usable. A report has figures "
            "for at most {most} photographs, and for at most {accepted} accepted ones. Run smaller groups to "
            "get figures for all of them."
        ).format(count=missing, most=MOST_WITH_FIGURES, accepted=MOST_ACCEPTED_WITH_FIGURES)
        return fill("left_out", words=long_text(words))


def _station(photo, summary, number):
    where = photo.longitude_deg, photo.latitude_deg
    return Station(
        *where, summary.name, summary.status, summary.heading_deg, summary.hfov_deg, anchor=f"photo-{number}"
    )


def picture_width_px(photos):
    """Width to which pictures are reduced in a report of this many photographs [pixels]."""
    return 1200 if photos <= 150 else 800 if photos <= 600 else 480
