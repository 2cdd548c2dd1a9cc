"""The report of horizon profiles: one drawing and a few numbers per point."""

from __future__ import annotations

from datetime import datetime

from .i18n import tr
from .outputs import make_folder_of
from .reporting import facts_of, software


class HorizonReport:
    """Profiles of points; a context manager, so that a failed or cancelled run leaves no file.

    Parameters
    ----------
    algorithm, parameters, context
        As in `processAlgorithm`; the report goes to the parameter `REPORT`, where that is wanted.
    """

    def __init__(self, algorithm, parameters, context):
        self.path = algorithm.parameterAsFileOutput(parameters, "REPORT", context)
        self.title, self.facts = algorithm.displayName(), facts_of(algorithm, parameters, context)
        self.software = software(algorithm)
        self._file = None

    def __enter__(self):
        if self.path:
            from ..core.io.report_file import ReportFile

            make_folder_of(self.path)
            self._file = ReportFile(self.path)
        return self

    def __exit__(self, kind, value, traceback):
        if self._file is None:
            return
        if kind is None:
            from ..core.draw_text import escape
            from ..core.report_page import page_head, page_tail, parameter_panel

            head = (
                f'<div class="page"><h1>{escape(self.title)}</h1><p class="quiet">{datetime.now():%Y-%m-%d %H:%M}</p>'
            )
            head += parameter_panel(self.facts)
            self._file.finish(page_head(self.title) + head, "</div>" + page_tail(self.software))
        else:
            self._file.discard()

    def add(self, row, profile, svf):
        """Append one point."""
        if self._file is None:
            return
        import numpy as np

        from ..core.draw_text import escape
        from ..core.figures_profile import horizon_profile_svg

        numbers = [
            tr("Position: {latitude:.5f}, {longitude:.5f}").format(
                latitude=row.latitude_deg, longitude=row.longitude_deg
            ),
            tr("Eye: {height:.0f} m").format(height=profile.eye_elevation_m),
            tr("Sky view factor: {svf:.3f}").format(svf=svf),
        ]
        if np.isfinite(profile.elevation_deg).any():
            numbers.append(
                tr("Highest horizon: {angle:.2f}°, farthest: {distance:.1f} km").format(
                    angle=np.nanmax(profile.elevation_deg), distance=np.nanmax(profile.distance_m) / 1000
                )
            )
        words = " · ".join(map(escape, numbers))
        figure = horizon_profile_svg(profile)
        self._file.write(f'<section class="panel"><h2>{escape(row.name)}</h2><p>{words}</p>{figure}</section>\n')

    def outputs(self):
        """Give the output's name and path."""
        return {"REPORT": self.path} if self.path else {}
