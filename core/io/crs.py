"""Coordinate reference systems: points to and from WGS 84, local ground frames, grid convergence.

A CRS is given as WKT or anything else that OSR reads ("EPSG:3413"). Coordinates are always in the traditional
order: longitude or easting first.
"""

from __future__ import annotations

import numpy as np
from osgeo import osr

from ..base.errors import TerrainError
from ..base.messages import Message
from .gdal_quiet import quiet_gdal

WGS84 = "EPSG:4326"
"""As all here, longitude first. To this one PROJ knows the way from a CRS on the datum WGS 84 without a search, and so
10 ms faster than to OGC:CRS84, which differs by its name and the order of its axes only."""
CYLINDRICAL = ("Mercator", "Equirectangular", "Cylindrical", "Miller", "Pseudo-Mercator", "Pseudo_Mercator")
"""Projection methods in whose plane the world repeats itself along x."""


def spatial_reference(crs):
    """Build an OSR spatial reference with the traditional axis order.

    Raises
    ------
    TerrainError
        PROJ does not understand `crs`.
    """
    reference = osr.SpatialReference()
    with quiet_gdal():
        try:
            failed = reference.SetFromUserInput(crs)
        except (RuntimeError, TypeError):  # TypeError: text that is no UTF-8, from a damaged header
            failed = True
    if failed:
        raise TerrainError(
            Message("The coordinate reference system {crs} is not recognised. Assign a valid one.", crs=repr(crs[:80]))
        )
    reference.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return reference


def _horizontal(crs):
    """Leave out a compound CRS's heights: a missing geoid grid must not cost us the plan position."""
    reference = spatial_reference(crs)
    if reference.IsCompound():
        reference.StripVertical()
    return reference


def local_plane(longitude_deg, latitude_deg):
    """CRS of true east and north on the ellipsoid around a place: azimuthal equidistant on WGS 84, metres."""
    return f"+proj=aeqd +lat_0={float(latitude_deg)!r} +lon_0={float(longitude_deg)!r} +datum=WGS84 +units=m +no_defs"


class Transformer:
    """Transformation of arrays of points from one CRS to another.

    Parameters
    ----------
    source, target : str
    area_deg : (west, south, east, north) or None
        WGS 84 area of interest [degrees]: lets PROJ settle on one datum shift for all points.
    """

    def __init__(self, source, target, area_deg=None):
        options = osr.CoordinateTransformationOptions()
        if area_deg is not None:
            options.SetAreaOfInterest(*area_deg)
        with quiet_gdal():
            try:
                self._transformation = osr.CoordinateTransformation(_horizontal(source), _horizontal(target), options)
            except RuntimeError:
                self._transformation = None
        if self._transformation is None or not self._transformation.this:
            names = repr(source[:60]), repr(target[:60])
            raise TerrainError(
                Message(
                    "No transformation from {source} to {target} is available. Use a DEM in a common coordinate "
                    "system.",
                    source=names[0],
                    target=names[1],
                )
            )

    def __call__(self, x, y):
        """Map coordinates; what lies outside the target's domain becomes NaN. Shapes broadcast together."""
        x, y = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))
        with quiet_gdal():
            points = self._transformation.TransformPoints(np.column_stack([x.ravel(), y.ravel()]).tolist())
        points = np.array(points, float)[:, :2].T.reshape((2, *x.shape))
        points[:, ~np.isfinite(points).all(axis=0)] = np.nan
        return points[0], points[1]


def from_wgs84(crs, longitude_deg, latitude_deg):
    """Map WGS 84 positions to coordinates of a CRS.

    Parameters
    ----------
    crs : str
        WKT, or any other text that GDAL understands.
    longitude_deg, latitude_deg : float or array
        [degrees].

    Returns
    -------
    x, y : float or array
        In the units of the CRS; NaN where it is not defined.
    """
    x, y = Transformer(WGS84, crs)(longitude_deg, latitude_deg)
    return x[()], y[()]


def to_wgs84(crs, x, y):
    """Map coordinates of a CRS to WGS 84 positions.

    Parameters
    ----------
    crs : str
        WKT, or any other text that GDAL understands.
    x, y : float or array
        In the units of the CRS.

    Returns
    -------
    longitude_deg, latitude_deg : float or array
        [degrees]; NaN where the transformation is not defined.
    """
    longitude_deg, latitude_deg = Transformer(crs, WGS84)(x, y)
    return longitude_deg[()], latitude_deg[()]


def x_period(crs):
    """Distance along x after which the CRS repeats the world, in its own units; None if it does not.

    360 degrees for longitudes; the equator's image for Mercator and the like. Used to follow a frame across the
    antimeridian.
    """
    reference = _horizontal(crs)
    if reference.IsGeographic():
        return 2 * np.pi / reference.GetAngularUnits()
    method = reference.GetAttrValue("PROJECTION") or ""
    if "Transverse" in method or "Oblique" in method or not any(name in method for name in CYLINDRICAL):
        return None
    centre_deg = reference.GetNormProjParm("central_meridian", 0.0)
    x, _ = from_wgs84(crs, np.array([centre_deg, centre_deg + 1.0]), np.zeros(2))
    return None if not np.isfinite(x).all() else abs(x[1] - x[0]) * 360
