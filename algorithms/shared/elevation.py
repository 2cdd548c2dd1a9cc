"""The DEM parameter: from the raster layer in QGIS to the terrain that the core reads."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf, isnan
from typing import Any

from qgis.core import QgsCoordinateReferenceSystem, QgsProcessingException, QgsRasterLayer

from ...core.base.errors import TerrainError
from .i18n import tr
from .lost_crs import crs_of, is_lost, raster_definition
from .parameters import dem_units
from .raster_parameter import no_statistics_file


@dataclass(frozen=True)
class DemSource:
    """The properties of the DEM that must be known outside QGIS's main thread.

    Attributes
    ----------
    path : str
        Path as GDAL opens it.
    band : int
        Number of the band, from 1.
    definition : str
        CRS of the layer, as `definition_of` gives it.
    assigned : str or None
        WKT of that CRS if the user has assigned it in place of the file's own.
    reading : DemReading
        Unit of the heights and nodata that the user has set.
    """

    path: str
    band: int
    definition: str
    assigned: str | None = None
    reading: Any = None

    @property
    def crs(self):
        """CRS of the DEM (QgsCoordinateReferenceSystem), made anew: QGIS may have lost that of the layer."""
        return crs_of(self.definition)

    def open(self):
        """Open the DEM as the core's `Dem`; raises `TerrainError`."""
        from ...core.io.dem_reading import DemReading
        from ...core.io.raster import open_dem

        return open_dem(self.path, self.band, self.assigned, self.reading or DemReading())


def dem_source(algorithm, parameters, context, name="DEM", band="BAND", unit="DEM_UNIT"):  # parameters: as in QGIS
    """Describe the DEM that the user chose.

    Raises
    ------
    QgsProcessingException
    """
    with no_statistics_file(parameters.get(name)):
        layer = algorithm.parameterAsRasterLayer(parameters, name, context)
        fault = layer_fault(layer)
        if fault:
            raise QgsProcessingException(fault)
        assigned, definition = assigned_crs(layer), raster_definition(layer)
    number = max(algorithm.parameterAsInt(parameters, band, context), 1)
    unit = dem_units()[algorithm.parameterAsEnum(parameters, unit, context)][0]
    return DemSource(layer.source(), number, definition, assigned, reading_of(layer, number, unit))


def reading_of(layer, band, unit):
    """Collect how the values are read: the unit, and the nodata that the user has set on the layer in QGIS."""
    from ...core.io.dem_reading import DemReading

    provider = layer.dataProvider()
    given = provider.userNoDataValues(band) if band <= provider.bandCount() else ()
    own = not provider.sourceHasNoDataValue(band) or provider.useSourceNoDataValue(band)
    return DemReading(unit, tuple(map(_limits, given)), own)


def _limits(values):
    """Limits of a range of nodata, both included; a side without a limit is infinite."""
    low, high = values.min(), values.max()
    return (-inf if isnan(low) else low, inf if isnan(high) else high)


def assigned_crs(layer):
    """WKT of the layer's CRS if it differs from the one in its file, else None."""
    with no_statistics_file(layer.source()):
        own = QgsRasterLayer(layer.source(), "own", "gdal", QgsRasterLayer.LayerOptions(False)).crs()
    if not layer.crs().isValid() or is_lost(layer.crs()) or layer.crs() == own:
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
