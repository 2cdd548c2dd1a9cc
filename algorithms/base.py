"""The base of all algorithms: identity, help, and the one place that converts core errors to those of QGIS."""

from __future__ import annotations

import os
from pathlib import Path

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingException,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterRasterDestination,
)
from qgis.PyQt.QtGui import QIcon

from ..core.base.errors import Cancelled, SkylineViewshedError
from .shared.elevation import dem_fault, dem_source
from .shared.i18n import in_users_language, tr
from .shared.outputs import destination
from .shared.reporting import facts_of, software
from .shared.styling import tell_provenance

ROOT = Path(__file__).resolve().parent.parent
DOCS = "https://github.com/skyline-viewshed/skyline_viewshed/blob/main/docs/algorithms.md"


class SkylineAlgorithm(QgsProcessingAlgorithm):
    """Base of the algorithms.

    A subclass sets `ID`, describes itself in `displayName`, `group`, `help_text` and `tags`, and does its work in
    `compute`, which may raise the core's errors. Files and layers are written when the work is done, so that a failed
    or cancelled run leaves no files behind.
    """

    ID = ""
    GROUP_ID = ""

    def createInstance(self):
        """Return a new instance to QGIS."""
        return type(self)()

    def name(self):
        """Identifier; never changes."""
        return self.ID

    def groupId(self):
        """Identifier of the group; never changes."""
        return self.GROUP_ID

    def group(self):
        """Group in the toolbox."""
        return {
            "photographs": tr("Photographs"),
            "terrain": tr("Terrain and visibility"),
            "all": tr("All in one"),
            "maps": tr("From the photo to the map"),
            "checks": tr("Checks and simulation"),
        }[self.GROUP_ID]

    def icon(self):
        """Icon in the toolbox."""
        return QIcon(self.svgIconPath())

    def svgIconPath(self):
        """Path of the same icon, which the toolbox prefers."""
        return str(ROOT / "icons" / f"{self.ID}.svg")

    def helpUrl(self):
        """Chapter of the algorithm reference."""
        return f"{DOCS}#{self.ID}"

    def shortHelpString(self):
        """Help beside the dialog: a description, with a picture if there is one."""
        picture = ROOT / "icons" / "help" / f"{self.ID}.jpg"
        image = f'<p><img src="{picture.as_uri()}" width="230"/></p>' if picture.exists() else ""
        paragraphs = "".join(f"<p>{paragraph}</p>" for paragraph in self.help_text())
        return f'{image}{paragraphs}<p><a href="{self.helpUrl()}">{tr("Reference")}</a></p>'

    def help_text(self):
        """Paragraphs of the help."""
        raise NotImplementedError

    def checkParameterValues(self, parameters, context):
        """Reject unusable input before anything starts, and explain how to correct it."""
        passed, message = super().checkParameterValues(parameters, context)
        if not passed:
            return passed, message
        message = self._destination_fault(parameters, context) or self.input_fault(parameters, context)
        return (False, in_users_language(message)) if message else (True, "")

    def input_fault(self, parameters, context):
        """Sentence about the first unusable input, or None."""
        return

    def processAlgorithm(self, parameters, context, feedback):
        """Run `compute`, and raise a core error as one of QGIS."""
        context.setFeedback(feedback)  # not every caller does; outputs and summits report through it
        try:
            results = self.compute(parameters, context, feedback)
            tell_provenance(context, facts_of(self, parameters, context), software(self))
            return results
        except Cancelled as stop:
            raise QgsProcessingException(tr("Cancelled. Nothing was written.")) from stop
        except SkylineViewshedError as error:
            raise QgsProcessingException(in_users_language(error.message)) from error

    def compute(self, parameters, context, feedback):
        """Do the work and return the outputs."""
        raise NotImplementedError

    def _destination_fault(self, parameters, context):
        files = QgsProcessingParameterFileDestination, QgsProcessingParameterRasterDestination
        for definition in self.destinationParameterDefinitions():
            value = destination(parameters.get(definition.name()), context)
            if isinstance(definition, QgsProcessingParameterFeatureSink) or not value or value == "TEMPORARY_OUTPUT":
                continue
            if value.startswith("memory:"):  # it would become a file of that name in the working folder
                return tr(
                    "{name} cannot be kept in memory, as only vector layers can. Choose a temporary file, or name a "
                    "file or folder."
                ).format(name=definition.name())
            if not isinstance(definition, files):
                continue
            folder = _nearest_folder(Path(value).expanduser().absolute().parent)
            if not os.access(folder, os.W_OK) or not folder.is_dir():
                return tr("{name} cannot be written: {folder} is not a folder you may write to.").format(
                    folder=folder, name=definition.name()
                )
        return None


class DemAlgorithm(SkylineAlgorithm):
    """An algorithm that reads an elevation model, which is in `self.dem` after `prepareAlgorithm`."""

    def input_fault(self, parameters, context):
        """Check the DEM."""
        return dem_fault(self, parameters, context)

    def prepareAlgorithm(self, parameters, context, feedback):
        """Read from the layers what they provide in the main thread only."""
        self.dem = dem_source(self, parameters, context)
        return True


def _nearest_folder(path):
    """Nearest ancestor that exists; missing folders below it are created when the output is written."""
    while not path.exists() and path != path.parent:
        path = path.parent
    return path
