"""The report of horizon profiles, written place by place and published complete at the end."""

from __future__ import annotations

from contextlib import ExitStack
from datetime import datetime

from .i18n import in_users_language, marked
from .outputs import make_folder_of
from .reporting import facts_of, software


class HorizonReport:
    """Profiles of points; a context manager, so that a failed or cancelled run leaves no file.

    Parameters
    ----------
    algorithm, parameters, context
        As in `processAlgorithm`; the report goes to the parameter `REPORT`, if requested.
    """

    WRITER = "horizon"

    def __init__(self, algorithm, parameters, context):
        self.path = algorithm.parameterAsFileOutput(parameters, "REPORT", context)
        self.title, self.facts = algorithm.displayName(), facts_of(algorithm, parameters, context)
        self.software = software(algorithm)
        self._stack, self._writer = ExitStack(), None

    def __enter__(self):
        if self.path:
            from ...core.io.report_file import ReportFile

            make_folder_of(self.path)
            writer = _writer(self.WRITER)(
                ReportFile(self.path),
                self.title,
                self.facts,
                software=self.software,
                created=datetime.now(),
                say=marked,
            )
            self._writer = self._stack.enter_context(writer)
        return self

    def __exit__(self, *failure):
        return self._stack.__exit__(*failure)

    def add(self, row, profile, svf):
        """Append one point."""
        if self._writer is not None:
            self._writer.add(row.name, profile, row.longitude_deg, row.latitude_deg, svf)

    def add_failed(self, row, message):
        """Append a point that has no horizon."""
        if self._writer is not None:
            self._writer.add_failed(row.name, in_users_language(message))

    def outputs(self):
        """Return the output's name and path."""
        return {"REPORT": self.path} if self.path else {}


def _writer(name):
    from ...core.report.horizon import HorizonReportWriter
    from ...core.report.orientability import OrientabilityReportWriter

    return {"horizon": HorizonReportWriter, "orientability": OrientabilityReportWriter}[name]
