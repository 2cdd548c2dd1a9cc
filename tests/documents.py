"""Reports as one text: output that goes to a file in a run is kept in memory."""

from __future__ import annotations

from skyline_viewshed.core.report.horizon import HorizonReportWriter
from skyline_viewshed.core.report.report import ReportWriter


class MemoryDocument:
    """A `core.report.page.Document` that keeps the result in `text`, and the files beside it in `files`."""

    folder, home = "report_files/cards-1", "../../report.html"

    def __init__(self):
        self._parts, self.text, self.files = [], "", {}

    def write(self, text):
        self._parts.append(text)

    def cut(self, count):
        taken, self._parts = self._parts[:count], self._parts[count:]
        return "".join(taken).encode("utf-8")

    def add(self, name, content):
        self.files[name] = content

    def finish(self, head, tail):
        self.text = "".join([head, *self._parts, tail])

    def discard(self):
        self._parts.clear()
        self.files.clear()


def report_html(photos, title, parameters=None, **options):
    """The report of a few `OrientedPhoto`s."""
    with ReportWriter(document := MemoryDocument(), title, parameters, expected_photos=len(photos), **options) as page:
        for photo in photos:
            page.add(photo)
    return document.text


def horizon_report_html(places, title):
    """The report of places: (name, HorizonProfile, longitude_deg, latitude_deg, sky_view_factor)."""
    with HorizonReportWriter(document := MemoryDocument(), title) as page:
        for place in places:
            page.add(*place)
    return document.text
