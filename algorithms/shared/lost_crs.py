"""Coordinate reference systems of which QGIS keeps the name only.

QGIS (3.22 to 3.44) keeps each system that it has read and hands it to all who ask for it. The thread that read it first
owns its definition: when that thread ends (QGIS ends idle ones after half a minute), a system without an authority's
code is still valid, but its definition is empty, also in layers that were opened elsewhere. Layers in memory then have
no system, and transformations leave coordinates as they are, both without an error.
"""

from __future__ import annotations

from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingException, QgsRasterLayer

from .i18n import tr

PREFERRED = QgsCoordinateReferenceSystem.WktVariant.WKT_PREFERRED


def is_lost(crs):
    """Tell whether QGIS has lost the definition of a valid system."""
    return crs.isValid() and not crs.authid() and not crs.toWkt()


def definition_of(crs):
    """Text from which `crs_of` makes the system again: the authority's code or the WKT; empty if it is invalid."""
    if not crs.isValid():
        return ""
    return crs.authid() or f"WKT:{crs.toWkt(PREFERRED)}"


def crs_of(definition):
    """Make a system from the text of `definition_of`; if the one that QGIS keeps is lost, QGIS reads it afresh."""
    crs = QgsCoordinateReferenceSystem(definition)
    if is_lost(crs):
        QgsCoordinateReferenceSystem.invalidateCache()
        crs = QgsCoordinateReferenceSystem(definition)
    return crs


def raster_crs(layer):
    """CRS of a raster layer; that of its file if QGIS has lost the layer's."""
    if not is_lost(layer.crs()):
        return layer.crs()
    QgsCoordinateReferenceSystem.invalidateCache()
    return QgsRasterLayer(layer.source(), "own", "gdal", QgsRasterLayer.LayerOptions(False)).crs()


def raster_definition(layer):
    """Definition of a raster layer's CRS.

    Call it in the main thread, which does not end: read there first, the system stays whole in layers that other
    threads make.
    """
    definition = definition_of(raster_crs(layer))
    crs_of(definition)
    return definition


def loss(crs):
    """Sentence if QGIS has lost the definition of a layer's system, else None."""
    if not is_lost(crs):
        return None
    return tr(
        "QGIS has lost the definition of the layer's coordinate reference system. Set the system in the layer's "
        "properties again, or remove the layer from the project and add it again."
    )


def check_not_lost(crs):
    """Raise `QgsProcessingException` if QGIS has lost the definition of a system."""
    fault = loss(crs)
    if fault:
        raise QgsProcessingException(fault)
