"""Elevation models read by GDAL, which are opened once and read in windows, never as a whole."""

from __future__ import annotations

import os

import numpy as np
from osgeo import gdal

from ..base.angles import wrap_180
from ..base.errors import ObserverOutsideDemError, UnusableDemError
from ..base.frame import tabulate_frame
from ..base.messages import Message
from ..base.terrain import Terrain, Window
from .crs import WGS84, Transformer, area_around, from_wgs84, local_plane, spatial_reference, to_wgs84, x_period
from .gdal_quiet import direct_reading, open_quietly, quiet_gdal, small_cache
from .georeference import check_band, crs_of, geotransform_of

PLAUSIBLE_M = (-12_000.0, 30_000.0)
"""Range of elevations on Earth, with a margin; values outside it are fill values (-32768, -3.4e38, 1e20, ...), tagged
or not."""

COMMON_FILL = -9999.0
"""Value that counts as nodata even without a tag; as a depth it occurs in ocean trenches only."""

METRES_PER_UNIT = {"ft": 0.3048, "foot": 0.3048, "feet": 0.3048, "us-ft": 1200 / 3937, "us survey foot": 1200 / 3937,
                   "ussurveyfoot": 1200 / 3937, "cm": 0.01, "dm": 0.1, "km": 1000.0}  # fmt: skip
"""Factors by the band's unit; all other units count as metres."""

STRIP_BYTES = 16 * 2**20

SEARCHED_CELLS = 500_000_000
"""Number of cells searched for a valid one before a raster counts as empty, which takes some seconds."""

LOWLAND_M = 100.0
"""Terrain with 99 % of its cells above this has no sea, so that zeros along its edges are missing data [m]."""


def open_dem(path, band=1, crs=None):
    """Open an elevation model.

    Parameters
    ----------
    path : str
        Anything that GDAL reads as a raster with a CRS: GeoTIFF, COG, HGT, VRT, ...
    band : int
        Number of the band, from 1.
    crs : str or None
        WKT or anything that OSR reads, used instead of the file's own CRS, for example one assigned in QGIS.

    Returns
    -------
    Dem

    Raises
    ------
    UnusableDemError
    """
    path = os.fspath(path)
    with direct_reading():
        dataset = open_quietly(path)
    if dataset is None:
        if not os.path.exists(path):
            raise UnusableDemError(Message("The DEM {path} does not exist. Check the path.", path=path))
        raise UnusableDemError(
            Message("The DEM {path} is not a raster that GDAL can read. Choose an elevation raster.", path=path)
        )
    with quiet_gdal():  # only now GDAL reads the rest of the header and reports its faults
        check_band(path, dataset, band)
        dem = Dem(path, dataset, band, crs_of(path, dataset, crs), geotransform_of(path, dataset))
        dem._inspect()
    return dem


class Dem(Terrain):
    """Elevation model in a file.

    Attributes
    ----------
    path : str
    band : int
        Number of the band, from 1.
    shape : (rows, columns)
    crs_wkt : str
    geotransform : tuple of 6 floats
        Geotransform as in GDAL, without rotation.
    nodata : float or None
        Nodata value from the file's tag.
    zero_is_void : bool
        Whether zeros are read as missing data, because they lie untagged along the edges of a highland.
    """

    def __init__(self, path, dataset, band, crs_wkt, geotransform):
        self.path, self.band, self.crs_wkt, self.geotransform = path, band, crs_wkt, geotransform
        self.shape = dataset.RasterYSize, dataset.RasterXSize
        self._dataset, self._band = dataset, dataset.GetRasterBand(band)
        self.nodata = self._band.GetNoDataValue()
        with np.errstate(over="ignore"):
            self._fill = np.float32(np.nan if self.nodata is None else self.nodata)
        self.zero_is_void = False
        unit_m = METRES_PER_UNIT.get((self._band.GetUnitType() or "").strip().lower(), 1.0)
        scale, offset = self._band.GetScale(), self._band.GetOffset()
        self._scale = (1.0 if scale is None else scale) * unit_m
        self._offset = (0.0 if offset is None else offset) * unit_m
        masked = self._band.GetMaskFlags() & (gdal.GMF_PER_DATASET | gdal.GMF_ALPHA)
        self._mask = self._band.GetMaskBand() if masked else None

    def __repr__(self):
        rows, cols = self.shape
        name, width, height = spatial_reference(self.crs_wkt).GetName(), *map(abs, self.geotransform[1::4])
        return f"<Dem {os.path.basename(self.path)}: {rows} x {cols} cells of {width:.6g} x {height:.6g}, {name}>"

    def read(self, window):
        """See `Terrain.read`: gives float32 metres, with NaN for nodata, implausible values and void zeros."""
        out = np.empty((window.rows, window.cols), np.float32)
        self.read_into(window, out)
        return out

    def read_into(self, window, out):
        """See `Terrain.read_into`."""
        if window.clipped(self.shape) != window:
            raise ValueError(f"{window} reaches beyond the raster's {self.shape} cells")
        strip_rows = max(STRIP_BYTES // (4 * max(window.cols, 1)), 1)
        with small_cache(self._row_of_blocks(window.cols)):
            for start in range(0, window.rows if window.cols else 0, strip_rows):
                strip = out[start : start + strip_rows]
                self._read_strip(window.col, window.row + start, strip)

    def _row_of_blocks(self, cols):
        """Give the size in GDAL's cache of one row of blocks across a window [bytes]."""
        width, height = self._band.GetBlockSize()
        return (cols // width + 2) * width * height * max(gdal.GetDataTypeSize(self._band.DataType) // 8, 1)

    def _read_strip(self, col, row, strip):
        rows, cols = strip.shape
        with quiet_gdal() as messages:
            try:
                done = self._band.ReadAsArray(col, row, cols, rows, buf_obj=strip)
                hidden = None if self._mask is None else self._mask.ReadAsArray(col, row, cols, rows) == 0
            except RuntimeError as error:
                done, messages = None, [str(error)]
        if done is None:
            reason = "; ".join(messages)[:200]
            raise UnusableDemError(
                Message("The DEM {path} is damaged ({reason}). Copy it again.", path=self.path, reason=reason)
            )
        if hidden is None and self._surely_valid(float(strip.min()), float(strip.max())):
            return
        void = ~np.isfinite(strip)
        void |= (strip == self._fill) | (strip == np.float32(COMMON_FILL))
        if self.zero_is_void:
            void |= strip == 0
        if hidden is not None:
            void |= hidden
        if self._scale != 1.0 or self._offset != 0.0:
            np.multiply(strip, np.float32(self._scale), out=strip)
            np.add(strip, np.float32(self._offset), out=strip)
        with np.errstate(invalid="ignore"):
            void |= (strip <= PLAUSIBLE_M[0]) | (strip >= PLAUSIBLE_M[1])
        strip[void] = np.nan

    def _surely_valid(self, lowest, highest):
        """Tell whether no value in this range needs an individual check, which saves six of eight passes."""
        plausible = PLAUSIBLE_M[0] < lowest and highest < PLAUSIBLE_M[1]  # False for NaN too
        fill = lowest <= self._fill <= highest or lowest <= COMMON_FILL <= highest
        zero = self.zero_is_void and lowest <= 0 <= highest
        return plausible and not fill and not zero and self._scale == 1.0 and self._offset == 0.0

    def frame(self, longitude_deg, latitude_deg, radius_m):
        """See `Terrain.frame`: azimuthal equidistant on WGS 84 around the position, exact in any CRS.

        A frame continues across the antimeridian. It ends at the seam of a raster that spans the whole globe, and at
        the pole of a raster in longitude and latitude.

        Parameters
        ----------
        longitude_deg, latitude_deg : float
            WGS 84 position [degrees].
        radius_m : float
            Distance to which the frame must reach [m].

        Raises
        ------
        ObserverOutsideDemError
            If the raster's CRS is not defined at the position.
        """
        reach_deg = np.degrees(radius_m / 6_350_000.0)
        transform = Transformer(
            local_plane(longitude_deg, latitude_deg), self.crs_wkt, area_around(longitude_deg, latitude_deg, reach_deg)
        )
        centre_x, centre_y = transform(0.0, 0.0)
        if not (np.isfinite(centre_x) and np.isfinite(centre_y)):
            raise ObserverOutsideDemError(longitude_deg, latitude_deg)
        period, wrap = x_period(self.crs_wkt), None
        if period is not None:
            home_x = self._nearest_x(float(centre_x), period)
            wrap = lambda x: home_x + wrap_180((x - home_x) * (360 / period)) * (period / 360)  # noqa: E731

        def to_pixel(east_m, north_m):
            x, y = transform(east_m, north_m)
            return self._pixel(x if wrap is None else wrap(x), y)

        return tabulate_frame(longitude_deg, latitude_deg, to_pixel, radius_m)

    def local_of(self, observer, longitude_deg, latitude_deg):
        """Give the true (east, north) of positions relative to an observer [m].

        Parameters
        ----------
        observer : Observer
            Origin of the local metres.
        longitude_deg, latitude_deg : float or array
            WGS 84 positions [degrees].
        """
        plane = local_plane(observer.longitude_deg, observer.latitude_deg)
        return Transformer(WGS84, plane)(longitude_deg, latitude_deg)

    def pixel_of(self, longitude_deg, latitude_deg):
        """Give the (col, row) of WGS 84 positions [pixels]; NaN where the CRS is not defined."""
        x, y = from_wgs84(self.crs_wkt, longitude_deg, latitude_deg)
        period = x_period(self.crs_wkt)
        return self._pixel(x if period is None else self._nearest_x(x, period), y)

    def position_of(self, col_px, row_px):
        """Give the WGS 84 (longitude, latitude) of pixels [degrees]; the inverse of `pixel_of`."""
        x0, dx, _, y0, _, dy = self.geotransform
        longitude_deg, latitude_deg = to_wgs84(
            self.crs_wkt, x0 + dx * np.add(col_px, 0.5), y0 + dy * np.add(row_px, 0.5)
        )
        return wrap_180(longitude_deg), latitude_deg

    def _pixel(self, x, y):
        x0, dx, _, y0, _, dy = self.geotransform
        return (x - x0) / dx - 0.5, (y - y0) / dy - 0.5

    def _nearest_x(self, x, period):
        """Shift x by whole periods of the CRS to the repetition of the world in which the raster lies."""
        middle_x = self.geotransform[0] + self.geotransform[1] * self.shape[1] / 2
        return middle_x + wrap_180((x - middle_x) * (360 / period)) * (period / 360)

    def _inspect(self):
        """Refuse a raster without a valid cell, and determine whether zero means missing data."""
        sample, edge = self._sample()
        valid = sample[np.isfinite(sample)]
        if valid.size == 0 and not self._any_valid():
            raise UnusableDemError(
                Message(
                    "Band {band} of the DEM {path} has no valid cell. Choose another DEM.",
                    band=self.band,
                    path=self.path,
                )
            )
        land = valid[valid != 0]
        self.zero_is_void = bool((edge == 0).any() and land.size >= 100 and np.percentile(land, 1) > LOWLAND_M)

    def _sample(self, side=9, patch=16):
        """Read `side` x `side` small windows, evenly spread with the corners; give all cells and those at the edge."""
        rows, cols = self.shape
        values, edge = [], []
        for row in np.unique(np.linspace(0, max(rows - patch, 0), side).astype(int)):
            for col in np.unique(np.linspace(0, max(cols - patch, 0), side).astype(int)):
                cells = self.read(Window(int(row), int(col), patch, patch).clipped(self.shape))
                values.append(cells.ravel())
                if row == 0:
                    edge.append(cells[0])
                if col == 0:
                    edge.append(cells[:, 0])
                if row + patch >= rows:
                    edge.append(cells[-1])
                if col + patch >= cols:
                    edge.append(cells[:, -1])
        return np.concatenate(values), np.concatenate(edge)

    def _any_valid(self):
        """Search strips for a valid cell: all of them up to `SEARCHED_CELLS`, else evenly spaced ones."""
        rows, cols = self.shape
        height = self._band.GetBlockSize()[1]
        height *= max(STRIP_BYTES // (4 * cols * height), 1)
        starts = np.arange(0, rows, height)
        most = max(SEARCHED_CELLS // (height * cols), 1)
        if len(starts) > most:
            starts = starts[np.linspace(0, len(starts) - 1, most).astype(int)]
        return any(
            np.isfinite(self.read(Window(int(row), 0, height, cols).clipped(self.shape))).any() for row in starts
        )
