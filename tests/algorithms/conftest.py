"""QGIS with Processing and our provider, and a feedback that remembers."""

from __future__ import annotations

from types import SimpleNamespace

import pytest
from map_layers import REACH_M, memory_layer
from qgis.core import QgsApplication, QgsProcessingContext, QgsProcessingFeedback, QgsProject
from qgis.PyQt.QtCore import QVariant


@pytest.fixture
def algorithm(provider):
    """Give an algorithm of ours by its id."""

    def find(name):
        found = QgsApplication.processingRegistry().algorithmById(f"skylineviewshed:{name}")
        assert found is not None, f"{name} is not in the registry"
        return found.create()

    return find


class Listener(QgsProcessingFeedback):
    """Feedback that remembers what it was told, and may cancel at a given progress."""

    def __init__(self, cancel_at=None):
        super().__init__(False)
        self.infos, self.warnings, self.errors, self.texts, self.fractions = [], [], [], [], []
        self.details = []
        self.cancel_at = cancel_at
        self.progressChanged.connect(self._moved)

    def _moved(self, percent):
        self.fractions.append(percent)
        if self.cancel_at is not None and percent >= self.cancel_at:
            self.cancel()

    def pushInfo(self, info):
        self.infos.append(info)

    def pushDebugInfo(self, info):
        self.details.append(info)

    def pushWarning(self, warning):
        self.warnings.append(warning)

    def reportError(self, error, fatalError=False):
        self.errors.append(error)

    def setProgressText(self, text):
        self.texts.append(text)


@pytest.fixture
def listener():
    """Make a fresh listener."""
    return Listener


@pytest.fixture
def run(provider):
    """Run an algorithm of ours in process: (results, feedback); layers stay alive in the context."""
    import processing

    def call(name, parameters, feedback=None, context=None):
        feedback = feedback or Listener()
        context = context or QgsProcessingContext()
        context.setProject(QgsProject.instance())
        results = processing.run(
            f"skylineviewshed:{name}", parameters, feedback=feedback, context=context, is_child_algorithm=False
        )
        return results, feedback

    return call


@pytest.fixture
def refusal(algorithm):
    """Message with which `checkParameterValues` refuses parameters, or '' where it accepts them."""

    def ask(name, parameters):
        context = QgsProcessingContext()
        context.setProject(QgsProject.instance())
        passed, message = algorithm(name).checkParameterValues(parameters, context)
        return "" if passed else message

    return ask


@pytest.fixture(scope="session")
def oriented(qgis_app, scene):
    """The scene's photographs with their true poses, as orientphotos would write them."""
    real, text = QVariant.Double, QVariant.String
    fields = [("photo", text), ("heading", real), ("pitch", real), ("roll", real), ("hfov", real), ("vfov", real)]
    fields += [("eye_z", real), ("heading_lo", real), ("heading_hi", real), ("status", text)]
    rows = []
    for name, pose in scene.truth.items():
        lon, lat = scene.positions[name]
        values = [str(scene.folder / f"{name}.jpg"), pose.heading_deg, pose.pitch_deg, pose.roll_deg, scene.hfov_deg]
        values += [None, None, pose.heading_deg - 0.3, pose.heading_deg + 0.3, "accepted"]
        rows.append((f"Point({lon!r} {lat!r})", values))
    return memory_layer("Point", fields, rows)


@pytest.fixture(scope="session")
def known(scene):
    """The north photo as the core has it: view and terrain."""
    from skyline_viewshed.core.base.camera import Camera, focal_of_fov_px
    from skyline_viewshed.core.base.posed import PosedPhoto
    from skyline_viewshed.core.base.terrain import Observer
    from skyline_viewshed.core.base.view import open_view
    from skyline_viewshed.core.io.raster import open_dem

    dem = open_dem(str(scene.dem))
    camera = Camera(800, 600, focal_of_fov_px(800, scene.hfov_deg))
    view = open_view(dem, PosedPhoto(camera, scene.truth["north"], Observer(*scene.positions["north"], 1.7)), REACH_M)
    return SimpleNamespace(dem=dem, view=view, camera=camera)
