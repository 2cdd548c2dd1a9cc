"""The plugin's entry point for QGIS: it registers the Processing provider, and shows in the desktop where to begin."""

from __future__ import annotations

from pathlib import Path

from qgis.core import Qgis, QgsApplication, QgsSettings
from qgis.PyQt.QtCore import QCoreApplication, QTranslator
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QAction

from .algorithms.shared.i18n import tr
from .processing_provider.provider import SkylineViewshedProvider

TRANSLATIONS = Path(__file__).parent / "i18n"
GREETED = "skyline_viewshed/greeted"
"""Setting that records that the user has been told where to begin."""


class SkylineViewshedPlugin:
    """The life cycle of the plugin: load the translation and the provider, and remove both again.

    Parameters
    ----------
    iface : QgisInterface or None
        None in qgis_process and on a server.
    """

    def __init__(self, iface):  # noqa: QGS105 (QGIS itself passes it)
        self.iface = iface
        self.provider = None
        self.translator = None
        self.start = self.dialog = None

    def initProcessing(self):
        """Register the provider; qgis_process calls only this step."""
        self._install_translation()
        # QGIS does not own a Python provider: without this reference its algorithms would disappear.
        self.provider = SkylineViewshedProvider()
        registry = QgsApplication.processingRegistry()
        registry.addProvider(self.provider)
        # Models find their steps only in registered providers: ours now, others perhaps later.
        self.provider.refreshAlgorithms()
        registry.providerAdded.connect(self._renew_models)

    def _renew_models(self, provider_id):
        if self.provider is not None and provider_id in ("native", "qgis", "gdal"):
            self.provider.refreshAlgorithms()

    def initGui(self):
        """Start in the desktop application."""
        self.initProcessing()
        self._show_where_to_begin()

    def _show_where_to_begin(self):
        """Add a button and a menu entry that open the main dialog, and point to them once, after the first start."""
        icon = QIcon(self.provider.svgIconPath())
        self.start = QAction(icon, tr("Photos to viewsheds"), self.iface.mainWindow())
        self.start.setObjectName("skylineViewshedStart")
        self.start.setToolTip(tr("Skyline Viewshed: choose photos and an elevation model, and run"))
        self.start.triggered.connect(self._begin)
        self.iface.addToolBarIcon(self.start)
        self.iface.addPluginToMenu("Skyline Viewshed", self.start)
        settings = QgsSettings()
        if not settings.value(GREETED, False, type=bool):
            settings.setValue(GREETED, True)
            text = tr("Begin with the mountain button in the toolbar, or in the Processing toolbox.")
            self.iface.messageBar().pushMessage("Skyline Viewshed", text, Qgis.MessageLevel.Info, 20)

    def _begin(self):
        """Open the dialog of the algorithm that does everything."""
        from qgis import processing

        self.dialog = processing.createAlgorithmDialog("skylineviewshed:photoviewshed", {})
        self.dialog.show()

    def unload(self):
        """Restore QGIS to its previous state."""
        if self.start is not None:
            self.iface.removeToolBarIcon(self.start)
            self.iface.removePluginMenu("Skyline Viewshed", self.start)
            self.start.deleteLater()
            self.start = None
        if self.provider is not None:
            registry = QgsApplication.processingRegistry()
            registry.providerAdded.disconnect(self._renew_models)
            registry.removeProvider(self.provider)
            self.provider = None
        if self.translator is not None:
            QCoreApplication.removeTranslator(self.translator)
            self.translator = None

    def _install_translation(self):
        compiled = TRANSLATIONS / f"skyline_viewshed_{QgsApplication.locale()[:2]}.qm"
        if compiled.exists():
            self.translator = QTranslator()
            self.translator.load(str(compiled))
            QCoreApplication.installTranslator(self.translator)
