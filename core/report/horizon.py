"""The HTML report of horizon profiles: one card per place, with a drawing of its horizon and its numbers."""

from __future__ import annotations

import numpy as np

from ..figures.profile import horizon_profile_svg
from ..figures.text import azimuth, degrees, with_unit
from .facts import percent
from .overview import badge, number_cell
from .page import DEFAULT_SOFTWARE, Frame, PageWriter, fact_table
from .pieces import fill, joined, long_text

MOST_WITH_FIGURES = 2_000
"""Most places that are drawn; a larger page would be hard to open."""


class HorizonReportWriter(PageWriter):
    """Write a report place by place; see `PageWriter` for the parameters and the use as a context manager."""

    def __init__(self, document, title, parameters=None, *, software=DEFAULT_SOFTWARE, created=None, say=str):
        super().__init__(document, title, parameters, software=software, created=created, say=say)
        self._rows = []

    def add(self, name, horizon, longitude_deg=None, latitude_deg=None, sky_view_factor=None, extras=None):
        """Append the card of one place.

        Parameters
        ----------
        name : str
            Name of the place; any text.
        horizon : HorizonProfile
        longitude_deg, latitude_deg : float or None
            WGS 84 [degrees].
        sky_view_factor : float or None
            0 to 1.
        extras : mapping or None
            Further labels and values.
        """
        say = self._say
        self._rows.append((name, _facts(horizon, sky_view_factor, say)))
        number = len(self._rows)
        rows = [(say("Latitude"), degrees(latitude_deg, 6)), (say("Longitude"), degrees(longitude_deg, 6))]
        rows += [(label, words) for label, _, words in self._rows[-1][1]]
        rows += [(str(label), str(value)) for label, value in (extras or {}).items()]
        drawing = horizon_profile_svg(horizon, width=1280, height=240, say=say) if number <= MOST_WITH_FIGURES else ""
        half = -(-len(rows) // 2)
        titles = (say("Place and horizon"), rows[:half]), (say("Eye and DEM"), rows[half:])
        tables = joined(fact_table(title, part) for title, part in titles)
        self._card("place", name, joined([drawing, fill("numbers", tables=tables)]))

    def remember(self, name, horizon):
        """Take the place of a card that is written otherwise into the table."""
        self._rows.append((name, _facts(horizon, None, self._say)))

    def add_failed(self, name, message):
        """Append the card of a place without a horizon, with the reason."""
        self._rows.append((name, None))
        self._card("failed", name, fill("advice", words=long_text(message)), badge("failed", self._say))

    def _card(self, status, name, body, sign=""):
        anchor = f"place-{len(self._rows)}"
        card = fill("card", status=status, anchor=anchor, badge=sign, name=name, origin="", body=body)
        self._document.write(card)

    def _counts(self):
        say, count = self._say, len(self._rows)
        return [say("1 place") if count == 1 else say("{count} places").format(count=count)]

    def _frame(self):
        return Frame(overview=_table(self._rows, self._say))


def _facts(horizon, sky_view_factor, say):
    """(label, value to sort by, words) of a horizon."""
    elevation = np.asarray(horizon.elevation_deg, float)
    distance = np.asarray(horizon.distance_m, float) / 1000
    known, far = np.isfinite(elevation), np.isfinite(distance)
    highest = int(np.argmax(np.where(known, elevation, -np.inf))) if known.any() else None
    top = None if highest is None else float(elevation[highest])
    at = None if highest is None else float(horizon.azimuth_deg[highest])
    mean = float(elevation[known].mean()) if known.any() else None
    middle = float(np.median(distance[far])) if far.any() else None
    farthest = float(distance[far].max()) if far.any() else None
    clipped, void = float(np.mean(horizon.clipped)), float(np.mean(np.asarray(horizon.void, bool) | ~known))
    return [
        (say("Highest horizon"), top, degrees(top, 2, signed=True)),
        (say("at azimuth"), at, azimuth(at)),
        (say("Mean horizon"), mean, degrees(mean, 2, signed=True)),
        (say("Median distance"), middle, with_unit(middle, "km", 1)),
        (say("Farthest"), farthest, with_unit(farthest, "km", 1)),
        (say("Sky view factor"), sky_view_factor, with_unit(sky_view_factor, "", 3)),
        (say("Cut by DEM edge"), clipped, percent(clipped)),
        (say("Void"), void, percent(void)),
        (say("Eye elevation"), horizon.eye_elevation_m, with_unit(horizon.eye_elevation_m, "m", 1)),
        (say("Cell size"), horizon.cell_m, with_unit(horizon.cell_m, "m", 1)),
    ]


def _table(rows, say):
    labels = [label for label, _, _ in next((facts for _, facts in rows if facts), [])]
    heads = joined([fill("text_head", words=say("Place")), *(fill("number_head", words=label) for label in labels)])
    lines = []
    for number, (name, facts) in enumerate(rows, 1):
        cells = [fill("name_cell", name=name, anchor=f"place-{number}", reason="")]
        cells += [number_cell(value, words) for _, value, words in facts or [(label, None, "–") for label in labels]]
        lines.append(fill("place_row", cells=joined(cells)))
    return fill("overview", heads=heads, rows=joined(lines))
