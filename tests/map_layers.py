"""Layers of photo points and of pixels for the algorithms between photo and map: `from map_layers import base`."""

from __future__ import annotations

from qgis.core import QgsFeature, QgsField, QgsGeometry, QgsVectorLayer
from qgis.PyQt.QtCore import QVariant

REACH_M = 12_000.0


def memory_layer(kind, fields, rows, crs="EPSG:4326"):
    """Layer from rows of (WKT or None, attributes); fields are (name, QVariant type)."""
    layer = QgsVectorLayer(f"{kind}?crs={crs}" if crs else kind, "layer", "memory")
    layer.dataProvider().addAttributes([QgsField(name, type_) for name, type_ in fields])
    layer.updateFields()
    for wkt, attributes in rows:
        feature = QgsFeature(layer.fields())
        if wkt:
            feature.setGeometry(QgsGeometry.fromWkt(wkt))
        feature.setAttributes(attributes)
        layer.dataProvider().addFeature(feature)
    return layer


def base(oriented, scene, **more):
    """Parameters that these algorithms have in common, and others."""
    return {"INPUT": oriented, "DEM": str(scene.dem), "MAX_DISTANCE": REACH_M, **more}


def rows_of(layer):
    """Attributes of a layer by name."""
    return [dict(zip(feature.fields().names(), feature.attributes())) for feature in layer.getFeatures()]


def pixel_table(rows):
    """Table of (photo, x, y, label)."""
    return memory_layer("NoGeometry", [("photo", QVariant.String), ("x", QVariant.Double), ("y", QVariant.Double),
                                       ("label", QVariant.String)], [(None, row) for row in rows], crs="")  # fmt: skip
