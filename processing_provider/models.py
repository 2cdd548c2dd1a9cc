"""The models that ship with the provider, under fixed ids and readable titles."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsProcessingModelAlgorithm
from qgis.PyQt.QtGui import QIcon

from ..algorithms.i18n import tr

ROOT = Path(__file__).resolve().parent.parent


class ShippedModel(QgsProcessingModelAlgorithm):
    """A model from `models/`; its id is the file's name.

    Parameters
    ----------
    path : str
        Of the .model3 file.
    """

    def __init__(self, path):
        super().__init__()
        self.path = str(path)
        self.readable = self.fromFile(self.path)

    def createInstance(self):
        """Read the file anew: by then all providers of its steps are registered."""
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
