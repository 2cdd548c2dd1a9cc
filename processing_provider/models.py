"""The models that ship with the provider, under fixed ids and readable titles."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsProcessingModelAlgorithm
from qgis.PyQt.QtGui import QIcon

from ..algorithms.shared import parameters as shared
from ..algorithms.shared.i18n import mark, marked, tr

ROOT = Path(__file__).resolve().parent.parent

TEXTS = (
    mark("Folder of photographs"),
    mark("Include subfolders"),
    mark("Elevation model (DEM)"),
    mark("Maximum distance (m)"),
    mark("Land-cover raster"),
    mark("Photos"),
    mark("Oriented photos"),
    mark("Viewshed"),
    mark("Ground in view"),
    mark("Land cover in view"),
    mark("Report"),
    mark("Photos to orient again"),
    mark("Layer to update"),
    mark("Field with an approximate heading (°)"),
    mark("Landmarks"),
    mark("Updated layer"),
    mark(
        "Orients some photographs of a layer again, with an approximate heading or landmarks if you give them, "
        "updates the layer, and computes anew the ground that its photographs show."
    ),
    mark("Reads geotagged JPEG photographs with QGIS's own importer, orients them, and computes the ground they show."),
    mark(
        "Uses the headings that the cameras recorded, and computes the ground within the horizontal field of "
        "view. Phone compasses are often wrong by 5 to 10 degrees or more."
    ),
    mark(
        "Counts the cells of each class of a land-cover raster within the ground that each oriented photograph shows."
    ),
)
"""The English texts of the files. QGIS cannot translate a model's own texts, so they are replaced after reading it."""


def tooltips():
    """Tooltips of the models' inputs and outputs, by name, in the user's language."""
    return {
        "FOLDER": tr("JPEG and HEIC files with a GPS position."),
        "RECURSIVE": tr("Also searches all subfolders."),
        "DEM": shared.dem().help(),
        "MAX_DISTANCE": shared.max_distance(1.0).help(),
        "LANDCOVER": tr("Raster of classes, in any coordinate system."),
        "PHOTOS": tr("Points with heading, pitch, roll and field of view."),
        "VIEWSHED": tr("Number of photographs that show each cell, on the DEM's grid; nodata if it is unknown."),
        "POLYGONS": tr("One multipolygon per photograph, with the area seen (m²) and the farthest distance (m)."),
        "LAND_COVER": tr("Ground in view, with the number of cells of each class in fields class_1, class_2, ..."),
        "REPORT": shared.report_out().help(),
        "AGAIN": tr("The layer of oriented photos; select the photos and tick the box for selected features."),
        "LAYER": tr("The layer that gets the new answers; usually the same one. It is changed."),
        "NEAR": tr("Approximate true heading, clockwise from north. The answer must be near it. NULL: none."),
        "LANDMARKS": tr("Points on the map that are visible in photographs, with the fields photo, x and y."),
    }


class ShippedModel(QgsProcessingModelAlgorithm):
    """A model from `models/`; its id is the file's name.

    Parameters
    ----------
    path : str
        Path of the .model3 file.
    """

    def __init__(self, path):
        super().__init__()
        self.path = str(path)
        self.readable = self.fromFile(self.path)
        self._translate()

    def _translate(self):
        """Translate labels and help into the user's language; the steps' names in the log stay as in the file."""
        texts = tooltips()
        for definition in self.parameterDefinitions():
            definition.setDescription(marked(definition.description()))
            definition.setHelp(texts.get(definition.name().split(":")[-1], ""))
        for output in self.outputDefinitions():
            output.setDescription(marked(output.description()))
        content = self.helpContent()
        self.setHelpContent({**content, "ALG_DESC": marked(content.get("ALG_DESC", ""))})

    def createInstance(self):
        """Read the file again: by then all providers of its steps are registered."""
        instance = ShippedModel(self.path)
        instance.setProvider(self.provider())
        return instance

    def name(self):
        """Identifier; never changes."""
        return Path(self.path).stem

    def displayName(self):
        """Title in the toolbox."""
        titles = {
            "geotaggedphotos": tr("Model: geotagged photos to viewsheds"),
            "compassviewsheds": tr("Model: recorded headings to viewsheds"),
            "orientagain": tr("Model: orient photos again"),
            "viewshedlandcover": tr("Model: land cover that photos show"),
        }
        return titles.get(self.name(), self.name())

    def groupId(self):
        """Identifier of the group."""
        return "models"

    def group(self):
        """Group in the toolbox."""
        return tr("Models")

    def icon(self):
        """Icon in the toolbox."""
        return QIcon(self.svgIconPath())

    def svgIconPath(self):
        """Path of the same icon, which the toolbox prefers."""
        return str(ROOT / "icons" / "model.svg")


def shipped_models():
    """All models of the folder that this QGIS can read."""
    models = [ShippedModel(path) for path in sorted((ROOT / "models").glob("*.model3"))]
    return [model for model in models if model.readable]
