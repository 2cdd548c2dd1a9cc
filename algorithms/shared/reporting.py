"""The HTML report of a run: written photo by photo to a temporary file and published complete at the end."""

from __future__ import annotations

from contextlib import ExitStack
from datetime import datetime
from pathlib import Path

from qgis.core import Qgis

from .i18n import marked, tr
from .oriented import in_readers_language
from .outputs import make_folder_of


class PhotoReport:
    """Report of oriented photographs; a context manager, so that a failed or cancelled run leaves no file.

    Parameters
    ----------
    algorithm, parameters, context
        As in `processAlgorithm`; the report goes to the parameter `REPORT`, if requested.
    expected : int
        Number of photographs expected.
    """

    def __init__(self, algorithm, parameters, context, expected):
        self.path = algorithm.parameterAsFileOutput(parameters, "REPORT", context)
        self.title, self.expected = algorithm.displayName(), expected
        self.facts = facts_of(algorithm, parameters, context)
        self.software = software(algorithm)
        self._stack, self._writer = ExitStack(), None

    def __enter__(self):
        if self.path:
            from ...core.io.report_file import ReportFile
            from ...core.report.report import ReportWriter

            make_folder_of(self.path)
            writer = ReportWriter(
                ReportFile(self.path),
                self.title,
                self.facts,
                software=self.software,
                created=datetime.now(),
                expected_photos=self.expected,
                say=marked,
            )
            self._writer = self._stack.enter_context(writer)
        return self

    def __exit__(self, *failure):
        return self._stack.__exit__(*failure)

    def add(self, oriented, extras=None, panels=None):
        """Append the card of one photo."""
        if self._writer is not None:
            self._writer.add(in_readers_language(oriented), extras, panels)

    def outputs(self):
        """Return the output's name and path."""
        return {"REPORT": self.path} if self.path else {}


def software(algorithm):
    """Name and version of plugin and QGIS."""
    provider = algorithm.provider()
    ours = "Skyline Viewshed" if provider is None else provider.longName()
    return f"{ours}, QGIS {Qgis.QGIS_VERSION}"


def facts_of(algorithm, parameters, context):
    """Labels and values of the run's parameters, as the report lists them."""
    facts = {}
    for definition in algorithm.parameterDefinitions():
        if definition.isDestination():
            continue
        value = value_in_words(algorithm, definition, parameters, context)
        if value:
            facts[definition.description()] = value
    return facts


def value_in_words(algorithm, definition, parameters, context):
    """Value of a parameter in words."""
    name, kind = definition.name(), definition.type()
    if kind == "enum" and definition.allowMultiple():
        return ", ".join(definition.options()[k] for k in algorithm.parameterAsEnums(parameters, name, context))
    if kind == "enum":
        return definition.options()[algorithm.parameterAsEnum(parameters, name, context)]
    if kind in ("distance", "number"):
        return f"{algorithm.parameterAsDouble(parameters, name, context):g}"
    if kind == "boolean":
        return tr("yes") if algorithm.parameterAsBoolean(parameters, name, context) else tr("no")
    if kind in ("raster", "source", "vector"):
        value = parameters.get(name)
        return Path(value).name if isinstance(value, str) else getattr(value, "name", lambda: "")()
    if kind in ("field", "file", "string"):
        return algorithm.parameterAsString(parameters, name, context)
    return str(algorithm.parameterAsInt(parameters, name, context)) if kind == "band" else ""
