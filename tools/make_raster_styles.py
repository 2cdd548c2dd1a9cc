"""Build the styles of rasters with PyQGIS: styles/viewshed.qml, seen.qml, layers.qml and others."""

from __future__ import annotations

import sys
from pathlib import Path

from qgis.core import (
    QgsApplication,
    QgsColorRampLegendNodeSettings,
    QgsColorRampShader,
    QgsRasterLayer,
    QgsRasterShader,
    QgsSingleBandPseudoColorRenderer,
)
from qgis.PyQt.QtGui import QColor

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "build" / "plugins"))
CLEARANCE_BAND = 3
STEPS, SMOOTH = QgsColorRampShader.Type.Discrete, QgsColorRampShader.Type.Interpolated

COUNTS = (
    (0, "#00ffffff", "not seen"),
    (1, "#ffc400", "1 photo"),
    (2, "#ff8f00", "2 photos"),
    (3, "#f4511e", "3 photos"),
    (5, "#d81b60", "4 to 5 photos"),
    (10, "#8e24aa", "6 to 10 photos"),
    (65534, "#311b92", "more than 10 photos"),
)
"""Number of photographs that see a cell: unseen ground is transparent, then from yellow to dark red."""

SEEN = ((0, "#00ffffff", "not seen"), (1, "#ffc400", "seen"))
"""Visibility in the raster of one photograph."""

CLEARANCES = (
    (-200, "#14213d", "hidden, 200 m or more too low"),
    (-50, "#4a6488", "hidden, 50 m too low"),
    (-10, "#93a9c4", "hidden, 10 m too low"),
    (-0.001, "#dbe4ee", "just hidden"),
    (0, "#ffc400", "just seen"),
    (10, "#ff8f00", "seen, 10 m to spare"),
    (100, "#d81b60", "seen, 100 m or more to spare"),
)
"""Height above the line of sight [m]; the sharp step lies between hidden and visible ground."""

PROBABILITIES = (
    (0.0, "#00ffffff", "0"),
    (0.1, "#90fdd97a", "0.1"),
    (0.5, "#d8f98e3c", "0.5"),
    (0.9, "#c2185b", "0.9"),
    (1.0, "#7b1fa2", "1"),
)

SKY_VIEWS = (
    (0.0, "#0b1026", "0"),
    (0.5, "#27408b", "0.5"),
    (0.7, "#3f7fbf", "0.7"),
    (0.8, "#74b3d8", "0.8"),
    (0.9, "#bfe0ee", "0.9"),
    (1.0, "#fffde7", "1 (open sky)"),
)
"""Sky view factor. Most ground sees more than half of the sky, so the upper half of the range has most colours."""


def main():
    """Write all styles."""
    application = QgsApplication([], False)
    application.initQgis()
    from skyline_viewshed.tools.make_styles import save

    for name, stops, kind, opacity, band in (
        ("viewshed", COUNTS, STEPS, 0.65, 1),
        ("seen", SEEN, STEPS, 0.65, 1),
        ("layers", CLEARANCES, SMOOTH, 0.75, CLEARANCE_BAND),
        ("probability", PROBABILITIES, SMOOTH, 0.8, 1),
        ("sky_view", SKY_VIEWS, SMOOTH, 1.0, 1),
    ):
        layer = empty_raster(band)
        layer.setRenderer(coloured(layer, stops, kind, band))
        layer.renderer().setOpacity(opacity)
        save(layer, name)


def empty_raster(bands):
    """Create a layer with as many bands as the style needs."""
    from osgeo import gdal

    path = "/vsimem/style.tif"
    gdal.GetDriverByName("GTiff").Create(path, 2, 2, bands, gdal.GDT_Float32).SetGeoTransform((0, 1, 0, 0, 0, -1))
    return QgsRasterLayer(path, "style")


def coloured(layer, stops, kind, band):
    """Colour by value; each stop has its own label in the legend."""
    ramp = QgsColorRampShader(stops[0][0], stops[-1][0], None, kind)
    items = [QgsColorRampShader.ColorRampItem(value, QColor(colour), label) for value, colour, label in stops]
    ramp.setColorRampItemList(items)
    if kind == SMOOTH:
        settings = QgsColorRampLegendNodeSettings()
        settings.setUseContinuousLegend(False)  # otherwise only the ends have labels
        ramp.setLegendSettings(settings)
    shader = QgsRasterShader()
    shader.setRasterShaderFunction(ramp)
    renderer = QgsSingleBandPseudoColorRenderer(layer.dataProvider(), band, shader)
    renderer.setClassificationMin(stops[0][0])
    renderer.setClassificationMax(stops[-1][0])
    return renderer


if __name__ == "__main__":
    main()
