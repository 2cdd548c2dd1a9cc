"""Coordinate reference systems: conversion of points to and from WGS 84, and local ground frames.

A CRS is given as WKT or anything else that OSR reads ("EPSG:3413"). Coordinates are always in the traditional
order, with longitude or easting first.
"""

from __future__ import annotations

import numpy as np
from osgeo import osr

from ..base.angles import wrap_180
from ..base.errors import TerrainError
from ..base.messages import Message
from .gdal_quiet import quiet_gdal

WGS84 = "EPSG:4326"
"""Used with longitude first, like all CRSs here. From a CRS on the datum WGS 84, PROJ finds the transformation to this
one without a search and so 10 ms faster than to OGC:CRS84, which differs only in its name and the order of its axes."""
CYLINDRICAL = ("Mercator", "Equirectangular", "Cylindrical", "Miller", "Pseudo-Mercator", "Pseudo_Mercator")
"""Projection methods in whose plane the world repeats along x."""


def spatial_reference(crs):
    """Build an OSR spatial reference with the traditional axis order.

    Raises
    ------
    TerrainError
        If OSR does not recognise `crs`.
    """
    reference = osr.SpatialReference()
    with quiet_gdal():
        try:
            failed = reference.SetFromUserInput(crs)
        except (RuntimeError, TypeError):  # TypeError: text that is not UTF-8, from a damaged header
            failed = True
    if failed:
        raise TerrainError(
            Message("The coordinate reference system {crs} is not recognised. Assign a valid one.", crs=repr(crs[:80]))
        )
    reference.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return reference


def _horizontal(crs):
    """Drop the heights of a compound CRS, so that a missing geoid grid does not prevent transforming x and y."""
    reference = spatial_reference(crs)
    if reference.IsCompound():
        reference.StripVertical()
    return reference


def local_plane(longitude_deg, latitude_deg):
    """Give the CRS of true east and north around a place: azimuthal equidistant on WGS 84, in metres."""
    return f"+proj=aeqd +lat_0={float(latitude_deg)!r} +lon_0={float(longitude_deg)!r} +datum=WGS84 +units=m +no_defs"


class Transformer:
    """Transformation of arrays of points from one CRS to another.

    Parameters
    ----------
    source, target : str
        WKT, or what `spatial_reference` takes.
    area_deg : (west, south, east, north) or None
        WGS 84 area of interest [degrees], with which PROJ chooses one datum shift for all points.
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
        """Transform coordinates, which broadcast together; NaN outside the domain of the target."""
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
        WGS 84 positions [degrees].

    Returns
    -------
    x, y : float or array
        Coordinates [units of the CRS]; NaN where the transformation is not defined.
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
        Coordinates [units of the CRS].

    Returns
    -------
    longitude_deg, latitude_deg : float or array
        WGS 84 positions [degrees]; NaN where the transformation is not defined.
    """
    longitude_deg, latitude_deg = Transformer(crs, WGS84)(x, y)
    return longitude_deg[()], latitude_deg[()]


def x_period(crs):
    """Give the distance along x after which the CRS repeats the world [units of the CRS]; None if it does not.

    This is 360 degrees for longitudes, and the length of the equator's image for Mercator and similar projections. It
    is used to continue a frame across the antimeridian.
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


def area_around(longitude_deg, latitude_deg, reach_deg):
    """Make the box around a position for PROJ's choice of a datum shift; west > east if it spans the antimeridian.

    Parameters
    ----------
    longitude_deg, latitude_deg : float
        WGS 84 position [degrees].
    reach_deg : float
        Distance from the position to the northern and southern edge [degrees].

    Returns
    -------
    west, south, east, north : float
        WGS 84 [degrees].
    """
    south, north = max(latitude_deg - reach_deg, -90.0), min(latitude_deg + reach_deg, 90.0)
    widest = max(abs(south), abs(north))
    if widest > 85:
        return -180.0, south, 180.0, north
    across = reach_deg / np.cos(np.radians(widest))
    return (
        float(wrap_180(longitude_deg - across)),
        float(south),
        float(wrap_180(longitude_deg + across)),
        float(north),
    )
