"""The plugin's entry point for QGIS: the Processing provider, and in the desktop where to begin and the Photo view."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from qgis.core import Qgis, QgsApplication, QgsSettings
from qgis.PyQt.QtCore import QCoreApplication, QTranslator
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QAction

from .algorithms.shared.i18n import tr
from .processing_provider.provider import SkylineViewshedProvider

TRANSLATIONS = Path(__file__).parent / "i18n"
GREETED = "skyline_viewshed/greeted"
"""Setting that records that the user has been told where to begin."""
MENU = "Skyline Viewshed"
"""The plugin's menu; a proper name, not translated."""


class SkylineViewshedPlugin:
    """The life cycle of the plugin: load the translation and the provider, and remove both again.

    Parameters
    ----------
    iface : QgisInterface or None
        None in qgis_process and on a server.
    """

    def __init__(self, iface):  # noqa: QGS105 (QGIS itself passes it)
        self.iface = iface
        self.provider: Any = None
        self.translator = None
        self.start = self.dialog = None
        self.photo_view = self.photo_view_action = None

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
        self._add_photo_view()

    def _show_where_to_begin(self):
        """Add a button and a menu entry that open the main dialog, and point to them once, after the first start."""
        icon = QIcon(self.provider.svgIconPath())
        self.start = QAction(icon, tr("Photos to viewsheds"), self.iface.mainWindow())
        self.start.setObjectName("skylineViewshedStart")
        self.start.setToolTip(tr("Skyline Viewshed: choose photos and an elevation model, and run"))
        self.start.triggered.connect(self._begin)
        self.iface.addToolBarIcon(self.start)
        self.iface.addPluginToMenu(MENU, self.start)
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

    def _add_photo_view(self):
        """Add the panel's button and menu entry; the panel itself is made when it is first opened."""
        title = tr("Photo view")
        icon = QIcon(str(Path(__file__).parent / "icons" / "photo_view.svg"))
        self.photo_view_action = QAction(icon, title, self.iface.mainWindow())
        self.photo_view_action.setToolTip(tr("Look at oriented photographs beside the map, correct and measure."))
        self.photo_view_action.triggered.connect(self.open_photo_view)
        self.iface.addToolBarIcon(self.photo_view_action)
        self.iface.addPluginToMenu(MENU, self.photo_view_action)

    def open_photo_view(self):
        """Open the panel for the active layer."""
        if self.photo_view is None:
            from .panel.controller import PhotoView

            self.photo_view = PhotoView(self.iface)
        self.photo_view.open()

    def unload(self):
        """Restore QGIS to its previous state."""
        if self.start is not None:
            self.iface.removeToolBarIcon(self.start)
            self.iface.removePluginMenu(MENU, self.start)
            self.start.deleteLater()
            self.start = None
        if self.photo_view is not None:
            self.photo_view.remove()
            self.photo_view = None
        if self.photo_view_action is not None:
            self.iface.removeToolBarIcon(self.photo_view_action)
            self.iface.removePluginMenu(MENU, self.photo_view_action)
            self.photo_view_action.deleteLater()
            self.photo_view_action = None
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
