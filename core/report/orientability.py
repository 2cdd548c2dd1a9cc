"""The report of orientability: one card per place, with its horizon and a rose of the predicted probability."""

from __future__ import annotations

from ..figures.profile import horizon_profile_svg
from ..figures.score import probability_rose_svg
from ..figures.text import degrees
from .facts import percent
from .horizon import HorizonReportWriter
from .page import fact_table
from .pieces import Html, fill, joined


class OrientabilityReportWriter(HorizonReportWriter):
    """Write a report place by place; see `PageWriter` for the parameters and the use as a context manager."""

    def add_place(self, name, position, horizon, predictions):
        """Append the card of one place.

        Parameters
        ----------
        name : str
        position : (longitude_deg, latitude_deg)
        horizon : HorizonProfile
        predictions : sequence of (hfov_deg, Orientability)
        """
        say = self._say
        self.remember(name, horizon)
        tables, roses = [], []
        for hfov_deg, found in predictions:
            roses.append(Html(probability_rose_svg(found.heading_deg, found.probability, size=240, say=say)))
            rows = [
                (say("Mean probability of a unique answer"), percent(found.mean)),
                (say("Expected error of the heading"), degrees(found.typical_error_deg, 2)),
            ]
            tables.append(fact_table(say("Field of view {hfov}°").format(hfov=f"{hfov_deg:.0f}"), rows))
        place = [(say("Latitude"), degrees(position[1], 6)), (say("Longitude"), degrees(position[0], 6))]
        tables.insert(0, fact_table(say("Place"), place))
        drawing = horizon_profile_svg(horizon, width=1280, height=240, say=say)
        self._card("place", name, joined([Html(drawing), *roses, fill("numbers", tables=joined(tables))]))
