"""Skyline Viewshed: which way a mountain photograph looks, how sure that is, and which ground it shows."""


def classFactory(iface):  # noqa: N802 - the name is QGIS's
    """Give QGIS the plugin; imported late so that pytest can collect this package without QGIS."""
    from .plugin import SkylineViewshedPlugin

    return SkylineViewshedPlugin(iface)
