"""The plugin's entry point for QGIS: it registers the Processing provider and nothing else."""

from __future__ import annotations

from pathlib import Path

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QCoreApplication, QTranslator

from .processing_provider.provider import SkylineViewshedProvider

TRANSLATIONS = Path(__file__).parent / "i18n"


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

    def unload(self):
        """Restore QGIS to its previous state."""
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
