"""Build the styles of the algorithms between photo and map, with PyQGIS: styles/placed_*.qml, image_*.qml, ..."""

from __future__ import annotations

import sys
from pathlib import Path

from qgis.core import (
    QgsApplication,
    QgsCategorizedSymbolRenderer,
    QgsFillSymbol,
    QgsGradientColorRamp,
    QgsGraduatedSymbolRenderer,
    QgsLineSymbol,
    QgsMarkerSymbol,
    QgsPalLayerSettings,
    QgsRendererCategory,
    QgsSingleSymbolRenderer,
    QgsTextBufferSettings,
    QgsTextFormat,
    QgsVectorLayerSimpleLabeling,
)
from qgis.PyQt.QtGui import QColor

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "build" / "plugins"))
ORANGE, INK = "#d95f02", "#1c2430"
STATES = {
    "visible": (ORANGE, "visible"),
    "hidden": ("#7a7f85", "hidden"),
    "outside": ("#c5cad1", "outside the picture"),
    "unknown": ("#b5179e", "unknown"),
}


def main():
    """Write all styles."""
    application = QgsApplication([], False)
    application.initQgis()
    from skyline_viewshed.algorithms.label_peaks import peak_specs
    from skyline_viewshed.algorithms.panorama import ridge_specs
    from skyline_viewshed.algorithms.shared.fields import qgis_fields
    from skyline_viewshed.algorithms.shared.image_features import line_specs
    from skyline_viewshed.algorithms.shared.image_features import point_specs as image_point_specs
    from skyline_viewshed.algorithms.shared.monoplotting import drawn_specs, ellipse_specs, point_specs
    from skyline_viewshed.tools.make_styles import save, vector_layer

    def layer(kind, specs):
        return vector_layer(kind, qgis_fields(specs))

    dot = {"name": "circle", "size": "2.6", "color": ORANGE, "outline_color": "white", "outline_width": "0.3"}
    top = {"name": "triangle", "size": "3.2", "outline_color": "white", "outline_width": "0.3"}
    line = {"line_color": ORANGE, "line_width": "0.7", "capstyle": "round", "joinstyle": "round"}
    area = {"color": "217,95,2,50", "outline_color": ORANGE, "outline_width": "0.6"}
    doubt = {"color": "242,177,52,45", "outline_color": "#b07a00", "outline_width": "0.3", "outline_style": "dash"}
    save(labelled(single(layer("PointZ", point_specs()), QgsMarkerSymbol.createSimple(dot)), "label"), "placed_points")
    save(single(layer("MultiLineStringZ", drawn_specs()), QgsLineSymbol.createSimple(line)), "placed_lines")
    save(single(layer("MultiPolygonZ", drawn_specs()), QgsFillSymbol.createSimple(area)), "placed_areas")
    save(single(layer("Polygon", ellipse_specs()), QgsFillSymbol.createSimple(doubt)), "error_ellipses")
    points = by_state(layer("Point", image_point_specs()), lambda c: QgsMarkerSymbol.createSimple({**dot, "color": c}))
    save(labelled(points, "name"), "image_points")
    save(by_state(layer("LineString", line_specs()), state_line), "image_lines")
    peaks = by_state(layer("PointZ", peak_specs()), lambda c: QgsMarkerSymbol.createSimple({**top, "color": c}))
    save(labelled(peaks, "name"), "peaks")
    save(by_distance(layer("LineString", ridge_specs())), "ridges")


def single(layer, symbol):
    """Use one symbol for all features."""
    layer.setRenderer(QgsSingleSymbolRenderer(symbol))
    return layer


def by_state(layer, symbol_of):
    """Use one colour for each state."""
    categories = [QgsRendererCategory(state, symbol_of(colour), label) for state, (colour, label) in STATES.items()]
    layer.setRenderer(QgsCategorizedSymbolRenderer("state", categories))
    return layer


def state_line(colour):
    """Make a line that is solid if visible, and dashed otherwise."""
    style = "solid" if colour == ORANGE else "dash"
    return QgsLineSymbol.createSimple({"line_color": colour, "line_width": "0.7", "line_style": style})


def by_distance(layer):
    """Draw near ridges dark and strong and far ones pale, as in the panorama."""
    renderer = QgsGraduatedSymbolRenderer("dist_med")
    renderer.setSourceSymbol(QgsLineSymbol.createSimple({"line_width": "0.5"}))
    for low, high in ((0, 1000), (1000, 3000), (3000, 10_000), (10_000, 30_000), (30_000, 500_000)):
        renderer.addClassLowerUpper(low, high)
    renderer.updateColorRamp(QgsGradientColorRamp(QColor("#26211c"), QColor("#7e98b8")))
    layer.setRenderer(renderer)
    return layer


def labelled(layer, field):
    """Put labels beside the points, with a white edge."""
    text, edge = QgsTextFormat(), QgsTextBufferSettings()
    text.setSize(8)
    text.setColor(QColor(INK))
    edge.setEnabled(True)
    edge.setSize(0.8)
    text.setBuffer(edge)
    settings = QgsPalLayerSettings()
    settings.fieldName = field
    settings.setFormat(text)
    layer.setLabeling(QgsVectorLayerSimpleLabeling(settings))
    layer.setLabelsEnabled(True)
    return layer


if __name__ == "__main__":
    main()
