"""Build the styles of photo points, polygons and horizons with PyQGIS.

Built this way, they contain only what this script sets, and nothing from anyone's desktop.
"""

from __future__ import annotations

import base64
import sys
from pathlib import Path

from qgis.core import (
    QgsApplication,
    QgsAttributeEditorContainer,
    QgsAttributeEditorField,
    QgsCategorizedSymbolRenderer,
    QgsClassificationEqualInterval,
    QgsEditFormConfig,
    QgsEditorWidgetSetup,
    QgsFillSymbol,
    QgsGeometryGeneratorSymbolLayer,
    QgsGradientColorRamp,
    QgsGraduatedSymbolRenderer,
    QgsMarkerSymbol,
    QgsProperty,
    QgsRendererCategory,
    QgsSimpleFillSymbolLayer,
    QgsSingleSymbolRenderer,
    QgsSvgMarkerSymbolLayer,
    QgsSymbol,
    QgsSymbolLayer,
    QgsUnitTypes,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QVariant
from qgis.PyQt.QtGui import QColor

ROOT = Path(__file__).resolve().parent.parent
WEDGE_MM = 11
STATUS_COLOURS = {
    "accepted": ("#1f8a5b", "accepted: trust it"),
    "confirmed": ("#0b6bcb", "confirmed by a person"),
    "ambiguous": ("#e69f00", "ambiguous: look at the report"),
    "rejected": ("#7a7f85", "rejected: no answer"),
    "failed": ("#c0392b", "failed: input at fault"),
}
CAMERA = (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24">'
    '<path d="M4 11 H8 L9.5 3 H14.5 L16 11 H20 A2 2 0 0 1 22 13 V20 A2 2 0 0 1 20 22 H4 A2 2 0 0 1 2 20 V13 '
    'A2 2 0 0 1 4 11 Z" fill="param(fill)" stroke="param(outline)" stroke-width="param(outline-width)"/></svg>'
)
"""Symbol of a camera from above, with the lens to the north."""


def main():
    """Write all styles."""
    application = QgsApplication([], False)
    application.initQgis()
    sys.path.insert(0, str(ROOT / "build" / "plugins"))
    from skyline_viewshed.algorithms.shared.fields import photo_specs, qgis_fields
    from skyline_viewshed.algorithms.shared.oriented import oriented_specs
    from skyline_viewshed.algorithms.shared.previews import preview_specs
    from skyline_viewshed.algorithms.shared.viewshed_outputs import polygon_specs

    (ROOT / "styles").mkdir(exist_ok=True)
    known = {spec.name: spec for spec in photo_specs() + oriented_specs() + preview_specs()}
    save(oriented(vector_layer("Point", qgis_fields(known.values()))), "oriented")
    save(photos(vector_layer("Point", qgis_fields(photo_specs() + preview_specs()))), "photos")
    save(polygons(vector_layer("MultiPolygon", qgis_fields(polygon_specs()))), "polygons")
    from skyline_viewshed.algorithms.horizon_profile import horizon_specs

    save(horizon(vector_layer("Point", qgis_fields(horizon_specs()))), "horizon")


def vector_layer(kind, fields):
    """Create an empty memory layer with the plugin's fields."""
    layer = QgsVectorLayer(f"{kind}?crs=EPSG:4326", "style", "memory")
    layer.dataProvider().addAttributes(fields.toList())
    layer.updateFields()
    return layer


def save(layer, name):
    """Write the style of a layer."""
    path = ROOT / "styles" / f"{name}.qml"
    layer.saveNamedStyle(str(path))
    print(path.relative_to(ROOT))


def camera_symbol(colour, heading):
    """Build a field-of-view wedge under a camera turned to the heading."""
    symbol = QgsMarkerSymbol()
    path = "base64:" + base64.b64encode(CAMERA.encode()).decode()
    camera = QgsSvgMarkerSymbolLayer(path, 5.0)
    camera.setFillColor(QColor(colour))
    camera.setStrokeColor(QColor("white"))
    camera.setStrokeWidth(0.2)
    camera.setDataDefinedProperty(
        QgsSymbolLayer.Property.PropertyAngle, QgsProperty.fromExpression(f'coalesce("{heading}", 0)')
    )
    symbol.changeSymbolLayer(0, wedge(colour, heading))
    symbol.appendSymbolLayer(camera)
    return symbol


def wedge(colour, heading):
    """Build the sector of the field of view in millimetres on the map; y runs downwards, so azimuth is mirrored."""
    expression = (
        f'if("{heading}" is null, null, wedge_buffer(centroid($geometry), 180 - "{heading}", '
        f'min(coalesce("hfov", 60), 359), {WEDGE_MM}))'
    )
    layer = QgsGeometryGeneratorSymbolLayer.create({"geometryModifier": expression})
    layer.setSymbolType(QgsSymbol.SymbolType.Fill)
    layer.setUnits(QgsUnitTypes.RenderUnit.RenderMillimeters)
    fill = QColor(colour)
    fill.setAlpha(70)
    sector = QgsSimpleFillSymbolLayer(fill)
    sector.setStrokeColor(QColor(colour))
    sector.setStrokeWidth(0.3)
    # Without a feature there is no wedge: in the legend it would fill a box fifteen times the size of the camera.
    for key, shown in (
        (QgsSymbolLayer.Property.PropertyFillColor, fill),
        (QgsSymbolLayer.Property.PropertyStrokeColor, QColor(colour)),
    ):
        rgba = ",".join(str(part) for part in shown.getRgb())
        sector.setDataDefinedProperty(key, QgsProperty.fromExpression(f"if($id is null, '0,0,0,0', '{rgba}')"))
    layer.setSubSymbol(fill_symbol(sector))
    return layer


def fill_symbol(symbol_layer):
    """Build a symbol of one layer that owns the layer, unlike one built from a list in the constructor in Python."""
    symbol = QgsFillSymbol()
    symbol.changeSymbolLayer(0, symbol_layer)
    return symbol


def oriented(layer):
    """Style oriented photos: coloured by status."""
    categories = [
        QgsRendererCategory(status, camera_symbol(colour, "heading"), label)
        for status, (colour, label) in STATUS_COLOURS.items()
    ]
    layer.setRenderer(QgsCategorizedSymbolRenderer("status", categories))
    layer.setMapTipTemplate(
        map_tip(
            "<b>[% coalesce(round(\"heading\", 1) || '°', 'no heading') %]</b> [% \"status\" %]<br/>"
            f"[% {plain(MESSAGE)} %]"
        )
    )
    return with_form(layer, ORIENTED_TABS)


def photos(layer):
    """Style imported photos: turned to the recorded heading."""
    layer.setRenderer(QgsSingleSymbolRenderer(camera_symbol("#2f6f9f", "direction")))
    layer.setMapTipTemplate(map_tip("[% coalesce('recorded ' || round(\"direction\", 1) || '°', '') %]"))
    return with_form(layer, PHOTO_TABS)


def map_tip(words):
    """Build a map tip of the picture, its name and some words."""
    photo = f'<img src="file:///[% {address(PICTURE)} %]" width="320"/>'
    return f"{photo}<br/>[% {plain(NAME)} %] {words}"


FOLDER = "file_path(layer_property(@layer, 'path'))"
"""Folder of the layer's file; paths in the field `preview` count from it."""

PREVIEW = "attribute($currentfeature, 'preview')"
"""Value of the field `preview`; NULL in a layer without it, where the field's own name would spoil the map tip."""

PICTURE = (
    f"with_variable('beside', {FOLDER} || '/' || {PREVIEW}, "
    f'if(file_exists(@beside), @beside, coalesce({PREVIEW}, "photo")))'
)
MESSAGE, NAME = '"message"', 'file_name("photo")'


def plain(expression):
    """Build an expression that escapes a text for HTML, since a file may be named like a tag."""
    return replaced(expression, (("&", "&amp;"), ("<", "&lt;"), ('"', "&quot;")))


def address(expression):
    """Build an expression for a path in the URL of a file."""
    return plain(replaced(expression, (("\\\\", "/"), ("%", "%25"), ("#", "%23"), ("?", "%3F"))))


def replaced(expression, pairs):
    for old, new in pairs:
        expression = f"replace({expression}, '{old}', '{new}')"
    return expression


ORIENTED_TABS = {
    "Answer": ("preview", "status", "heading", "heading_lo", "heading_hi", "p_correct", "message"),
    "Match": (
        *("pitch", "pitch_lo", "pitch_hi", "roll", "roll_lo", "roll_hi", "hfov", "hfov_lo", "hfov_hi", "vfov"),
        *("heading_2", "heading_3", "compass", "compass_df"),
        *("ncc", "ncc_2nd", "sharpness", "horizon_m"),
    ),
    "Place": (
        *("eye_z", "altitude", "h_acc", "longitude", "latitude", "observ_hgt", "radius", "azim_1", "azim_2"),
        "grid_conv",
    ),
    "Photo": (
        *("photo", "filename", "directory", "timestamp", "camera", "f35", "width", "height", "rotation"),
        *("direction", "dir_ref"),
    ),
}
"""Tabs of the form and their fields; it opens with the picture, the verdict and the heading."""

PHOTO_TABS = {
    "Photo": (
        *("preview", "filename", "direction", "dir_ref", "timestamp", "camera", "f35", "hfov", "vfov"),
        *("width", "height", "rotation", "photo", "directory"),
    ),
    "Place": ("altitude", "h_acc", "longitude", "latitude"),
}

DECIMALS = {
    **dict.fromkeys(("ncc", "ncc_2nd", "p_correct", "sharpness", "grid_conv"), 2),
    **dict.fromkeys(("altitude", "eye_z", "h_acc", "observ_hgt", "f35"), 1),
    **dict.fromkeys(("horizon_m", "radius"), 0),
}
"""Decimals that a value deserves; angles, and what is not listed, have one."""


def with_form(layer, tabs):
    """Give the attribute form its tabs, its picture, and as many decimals as the values deserve."""
    fields = layer.fields()
    for index, field in enumerate(fields):
        if field.type() == QVariant.Double:
            layer.setEditorWidgetSetup(index, number_widget(DECIMALS.get(field.name(), 1)))
    layer.setEditorWidgetSetup(fields.lookupField("preview"), picture_widget())
    link = {"DocumentViewer": 0, "FileWidget": True, "FileWidgetButton": True, "FileWidgetFilter": "",
            "UseLink": True, "FullUrl": True, "StorageMode": 0, "RelativeStorage": 0}  # fmt: skip
    layer.setEditorWidgetSetup(fields.lookupField("photo"), QgsEditorWidgetSetup("ExternalResource", link))
    if fields.lookupField("message") >= 0:
        lines = QgsEditorWidgetSetup("TextEdit", {"IsMultiline": True, "UseHtml": False})
        layer.setEditorWidgetSetup(fields.lookupField("message"), lines)
    config = layer.editFormConfig()
    config.setLayout(QgsEditFormConfig.EditorLayout.TabLayout)
    config.clearTabs()
    for title, names in tabs.items():
        tab = QgsAttributeEditorContainer(title, config.invisibleRootContainer())
        tab.setIsGroupBox(False)
        for name in names:
            tab.addChildElement(QgsAttributeEditorField(name, fields.lookupField(name), tab))
        config.addTab(tab)
    if fields.lookupField("preview") >= 0:
        config.setLabelOnTop(fields.lookupField("preview"), True)
    layer.setEditFormConfig(config)
    layer.setDisplayExpression('file_name("photo")')
    return layer


def number_widget(decimals):
    """Build the widget of a number with some decimals, in form and table."""
    limits = {"Min": -1e9, "Max": 1e9, "Step": 10.0**-decimals, "Precision": decimals, "Style": "SpinBox"}
    return QgsEditorWidgetSetup("Range", {**limits, "AllowNull": True})


def picture_widget():
    """Build the widget that shows the picture, whose path counts from the folder of the layer's file."""
    root = {"active": True, "expression": FOLDER, "type": 3}
    viewer = {"DocumentViewer": 1, "DocumentViewerHeight": 220, "DocumentViewerWidth": 0, "FileWidget": False,
              "FileWidgetButton": False, "StorageMode": 0, "RelativeStorage": 2, "DefaultRoot": "",
              "PropertyCollection": {"name": None, "properties": {"propertyRootPath": root},
                                     "type": "collection"}}  # fmt: skip
    return QgsEditorWidgetSetup("ExternalResource", viewer)


def polygons(layer):
    """Style the ground in view: one hue per photo, with the outline stronger than the fill."""
    fill = QgsSimpleFillSymbolLayer(QColor(230, 120, 30, 60))
    fill.setStrokeWidth(0.4)
    hue = '("source_id" * 137) % 360'
    fill.setDataDefinedProperty(
        QgsSymbolLayer.Property.PropertyFillColor, QgsProperty.fromExpression(f"color_hsla({hue}, 75, 50, 60)")
    )
    fill.setDataDefinedProperty(
        QgsSymbolLayer.Property.PropertyStrokeColor, QgsProperty.fromExpression(f"color_hsl({hue}, 80, 32)")
    )
    layer.setRenderer(QgsSingleSymbolRenderer(fill_symbol(fill)))
    layer.setMapTipTemplate(
        f'[% {plain(NAME)} %]<br/>[% round("area_m2" / 1e6, 2) %] km², up to [% round("farthest_m" / 1000, 1) %] km'
    )
    layer.setDisplayExpression('file_name("photo")')
    return layer


def horizon(layer):
    """Style the points of the horizon: coloured by elevation angle."""
    symbol = QgsMarkerSymbol.createSimple({"name": "circle", "size": "1.6", "outline_style": "no"})
    renderer = QgsGraduatedSymbolRenderer("elevation")
    renderer.setSourceSymbol(symbol)
    renderer.setClassificationMethod(QgsClassificationEqualInterval())
    ramp = QgsGradientColorRamp(QColor("#2c7bb6"), QColor("#d7191c"))
    for lower, upper in ((-90, 0), (0, 5), (5, 10), (10, 20), (20, 90)):
        renderer.addClassLowerUpper(lower, upper)
    renderer.updateColorRamp(ramp)
    layer.setRenderer(renderer)
    return layer


if __name__ == "__main__":
    main()
