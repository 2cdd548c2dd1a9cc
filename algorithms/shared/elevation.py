"""The DEM parameter: from the raster layer in QGIS to the terrain that the core reads."""

from __future__ import annotations

from dataclasses import dataclass

from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingException, QgsRasterLayer

from ...core.base.errors import TerrainError
from .i18n import tr


@dataclass(frozen=True)
class DemSource:
    """The properties of the DEM that must be known outside QGIS's main thread.

    Attributes
    ----------
    path : str
        Path as GDAL opens it.
    band : int
        Number of the band, from 1.
    crs : QgsCoordinateReferenceSystem
        CRS of the layer in QGIS.
    assigned : str or None
        WKT of that CRS if the user has assigned it in place of the file's own.
    """

    path: str
    band: int
    crs: QgsCoordinateReferenceSystem
    assigned: str | None = None

    def open(self):
        """Open the DEM as the core's `Dem`; raises `TerrainError`."""
        from ...core.io.raster import open_dem

        return open_dem(self.path, self.band, self.assigned)


def dem_source(algorithm, parameters, context, name="DEM", band="BAND"):
    """Describe the DEM that the user chose.

    Raises
    ------
    QgsProcessingException
    """
    layer = algorithm.parameterAsRasterLayer(parameters, name, context)
    fault = layer_fault(layer)
    if fault:
        raise QgsProcessingException(fault)
    number = max(algorithm.parameterAsInt(parameters, band, context), 1)
    return DemSource(layer.source(), number, layer.crs(), assigned_crs(layer))


def assigned_crs(layer):
    """WKT of the layer's CRS if it differs from the one in its file, else None."""
    own = QgsRasterLayer(layer.source(), "own", "gdal").crs()
    if not layer.crs().isValid() or layer.crs() == own:
        return None
    return layer.crs().toWkt(QgsCoordinateReferenceSystem.WktVariant.WKT_PREFERRED)


def dem_fault(algorithm, parameters, context, name="DEM", band="BAND"):
    """Sentence on why the DEM is unusable, or None; opens it, which takes milliseconds."""
    try:
        dem_source(algorithm, parameters, context, name, band).open()
    except TerrainError as error:
        return error.message
    except QgsProcessingException as error:
        return str(error)
    return None


def layer_fault(layer):
    """Sentence on what is wrong with the layer itself, or None."""
    if layer is None or not layer.isValid():
        return tr("The elevation model cannot be read. Choose a raster file with heights.")
    if layer.providerType() != "gdal":
        return tr(
            "The elevation model comes from a {provider} source. Save it as a GeoTIFF first and choose that."
        ).format(provider=layer.providerType())
    return None
