"""A raster parameter that leaves nothing beside the user's file."""

from __future__ import annotations

import os
from contextlib import nullcontext

from qgis.core import QgsProcessingParameterRasterLayer


class RasterParameter(QgsProcessingParameterRasterLayer):
    """Raster layer as QGIS has it, which QGIS opens without leaving its statistics beside the file.

    `qgis_process` opens the file of each raster parameter in `checkValueIsAcceptable`, before it calls the algorithm.
    """

    def clone(self):
        """Copy the parameter with its label, help and flags."""
        copy = RasterParameter(self.name(), self.description())
        copy.fromVariantMap(self.toVariantMap())
        return copy

    def checkValueIsAcceptable(self, value, context=None):
        """Tell whether a value names a raster, as QGIS does."""
        with no_statistics_file(value):
            return super().checkValueIsAcceptable(value, context)


def no_statistics_file(source):
    """Keep QGIS from leaving the statistics that it computes for a layer in a new .aux.xml beside the user's file.

    If there is one already it is left in use, because it may hold the CRS or the nodata value.
    """
    from ...core.io.gdal_quiet import split_options, without_sidecars

    path = split_options(source)[0] if isinstance(source, str) else ""
    if os.path.isfile(path) and not os.path.exists(f"{path}.aux.xml"):
        return without_sidecars()
    return nullcontext()
