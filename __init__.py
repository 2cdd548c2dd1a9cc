"""Skyline Viewshed: which way a mountain photograph looks, how sure that is, and which ground it shows.

QGIS loads this package as a plugin; everywhere else ``import skyline_viewshed as sv`` gives the functions of
`core.api`, which are imported when first used.
"""

__all__ = [
    "ArrayTerrain", "Cancelled", "DeviceAudit", "FullCircle", "HorizonOptions", "HorizonProfile", "LandmarkHint",
    "Observer", "OrientOptions", "OrientedPhoto", "Photo", "PhotoError", "PhotoMetadata", "PhotoRequest",
    "PosedPhoto", "SceneOptions", "SkylineViewshedError", "TerrainError", "Viewshed", "ViewshedOptions", "Wedge",
    "compass_audit", "dem_from_array", "example_terrain", "horizon_profile", "list_photos", "open_dem", "orient",
    "orient_many", "overlay", "place", "read_metadata", "read_photo", "save_points", "save_report", "save_viewshed",
    "simulate", "viewshed",
]  # fmt: skip


def classFactory(iface):  # noqa: N802 - the name is QGIS's
    """Give QGIS the plugin; imported late so that pytest can collect this package without QGIS."""
    from .plugin import SkylineViewshedPlugin

    return SkylineViewshedPlugin(iface)


def __getattr__(name):
    """Import the public functions when one is first asked for, so that QGIS loads the plugin without them."""
    if name == "__version__":
        return _version()
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from .core import api

    globals().update({public: getattr(api, public) for public in __all__})
    return globals()[name]


def __dir__():
    return sorted({*globals(), *__all__, "__version__"})


def _version():
    """Version of the plugin, which has it in metadata.txt."""
    from configparser import ConfigParser
    from pathlib import Path

    metadata = ConfigParser(interpolation=None)
    metadata.read(Path(__file__).parent / "metadata.txt", encoding="utf-8")
    return metadata["general"]["version"]
