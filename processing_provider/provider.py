"""The Processing provider `skylineviewshed`: its algorithms and the models that ship with it."""

from __future__ import annotations

from configparser import ConfigParser
from importlib import import_module
from pathlib import Path

from qgis.core import QgsProcessingProvider
from qgis.PyQt.QtGui import QIcon

from .models import shipped_models

ROOT = Path(__file__).resolve().parent.parent
PROVIDER_ID = "skylineviewshed"

ALGORITHMS = (
    ("photo_viewshed", "PhotoViewshed"),
    ("import_photos", "ImportPhotos"),
    ("position_photos", "PositionPhotos"),
    ("extract_skyline", "ExtractSkyline"),
    ("horizon_profile", "HorizonProfile"),
    ("orient_photos", "OrientPhotos"),
    ("merge_oriented", "MergeOriented"),
    ("export_headings", "ExportHeadings"),
    ("directed_viewshed", "DirectedViewshed"),
    ("measure_offsets", "MeasureOffsets"),
    ("simulate_photos", "SimulatePhotos"),
    ("pixel_to_map", "PixelToMap"),
    ("map_to_pixel", "MapToPixel"),
    ("drape_photo", "DrapePhoto"),
    ("label_peaks", "LabelPeaks"),
    ("which_photos", "WhichPhotos"),
    ("panorama", "Panorama"),
    ("photo_coverage", "PhotoCoverage"),
    ("locate_photos", "LocatePhotos"),
    ("position_check", "PositionCheck"),
    ("orientability", "Orientability"),
    ("expected_accuracy", "ExpectedAccuracy"),
)
"""(module under `algorithms`, class), in the order in which a user needs them."""


class SkylineViewshedProvider(QgsProcessingProvider):
    """Algorithms from photograph to viewshed."""

    def id(self):
        """Part of every algorithm's identifier; never changes."""
        return PROVIDER_ID

    def name(self):
        """Name shown in the toolbox; a proper name, not translated."""
        return "Skyline Viewshed"

    def longName(self):
        """Name and version, shown in the options dialog."""
        return f"{self.name()} {self.versionInfo()}"

    def versionInfo(self):
        """Return the plugin's version."""
        metadata = ConfigParser(interpolation=None)
        metadata.read(ROOT / "metadata.txt", encoding="utf-8")
        return metadata.get("general", "version", fallback="")

    def helpId(self):
        """Anchor of the help; the algorithms have their own links."""
        return PROVIDER_ID

    def icon(self):
        """Icon of the provider in the toolbox."""
        return QIcon(self.svgIconPath())

    def svgIconPath(self):
        """Path of the same icon, which the toolbox prefers."""
        return str(ROOT / "icons" / "provider.svg")

    def supportedOutputRasterLayerExtensions(self):
        """Return GeoTIFF, the only format that we write."""
        return ["tif", "tiff"]

    def defaultRasterFileExtension(self):
        """Suffix of temporary rasters."""
        return "tif"

    def loadAlgorithms(self):
        """Add the algorithms, then the models that are built from them."""
        for module, name in ALGORITHMS:
            self.addAlgorithm(getattr(import_module(f"..algorithms.{module}", __package__), name)())
        for model in shipped_models():
            self.addAlgorithm(model)
