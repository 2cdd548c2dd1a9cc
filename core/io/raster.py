"""Elevation models read by GDAL, which are opened once and read in windows, never as a whole."""

from __future__ import annotations

import os
from functools import cached_property

import numpy as np
from osgeo import gdal

from ..base.angles import wrap_180
from ..base.errors import ObserverOutsideDemError, UnusableDemError
from ..base.frame import tabulate_frame
from ..base.messages import Message
from ..base.terrain import Terrain
from .crs import WGS84, Transformer, area_around, from_wgs84, local_plane, spatial_reference, to_wgs84, x_period
from .dem_inspection import STRIP_BYTES, check_colours, inspect, windows
from .dem_reading import DemReading, in_ranges
from .file_state import dataset_state
from .gdal_quiet import bytes_of_block_row, direct_reading, open_quietly, quiet_gdal, small_cache, split_options
from .georeference import check_band, crs_of, geotransform_of
from .height_unit import metres_per_unit

PLAUSIBLE_M = (-12_000.0, 30_000.0)
"""Range of elevations on Earth, with a margin; values outside it are fill values (-32768, -3.4e38, 1e20, ...), tagged
or not."""

LONG_ROW = 1024
"""From this length on rows are reduced one by one, which is faster where they are not contiguous."""

INFINITY_BITS = 0x7F800000

COMMON_FILL = -9999.0
"""Value that counts as nodata even without a tag; as a depth it occurs in ocean trenches only."""


def open_dem(path, band=1, crs=None, reading=DemReading()):  # noqa: B008 - frozen
    """Open an elevation model.

    Parameters
    ----------
    path : str
        Anything that GDAL reads as a raster with a CRS: GeoTIFF, COG, HGT, VRT, ...; with `|option:KEY=VALUE` behind it
        for each open option, as QGIS writes them.
    band : int
        Number of the band, from 1.
    crs : str or None
        WKT or anything that OSR reads, used instead of the file's own CRS, for example one assigned in QGIS.
    reading : DemReading
        Unit and nodata that the user chose.

    Returns
    -------
    Dem

    Raises
    ------
    UnusableDemError
    """
    source = os.fspath(path)
    path, options = split_options(source)
    with direct_reading():
        dataset = open_quietly(path, options=options)
    if dataset is None:
        if not os.path.exists(path):
            raise UnusableDemError(Message("The DEM {path} does not exist. Check the path.", path=path))
        raise UnusableDemError(
            Message("The DEM {path} is not a raster that GDAL can read. Choose an elevation raster.", path=path)
        )
    with quiet_gdal():  # only now GDAL reads the rest of the header and reports its faults
        check_band(path, dataset, band)
        check_colours(path, dataset, band, reading.unit)
        dem = Dem(path, dataset, band, crs_of(path, dataset, crs), reading)
        dem.source, dem.zero_is_void = source, inspect(dem)
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
        Nodata value from the file's tag, unless the user has switched it off.
    reading : DemReading
    zero_is_void : bool
        Whether zeros are read as missing data, because they lie untagged along the edges of a highland.
    """

    def __init__(self, path, dataset, band, crs_wkt, reading):
        self.path, self.band, self.crs_wkt, self.reading = path, band, crs_wkt, reading
        self.source = path
        self.geotransform = geotransform_of(path, dataset)
        self.shape = dataset.RasterYSize, dataset.RasterXSize
        self._dataset, self._band = dataset, dataset.GetRasterBand(band)
        self.nodata = self._band.GetNoDataValue() if reading.own_nodata else None
        with np.errstate(over="ignore"):
            self._fill = np.float32(np.nan if self.nodata is None else self.nodata)
        self.zero_is_void = False
        self._unit_m = metres_per_unit(dataset, self._band, crs_wkt, reading.unit)
        scale, offset = self._band.GetScale(), self._band.GetOffset()
        self._scale = (1.0 if scale is None else scale) * self._unit_m
        self._offset = (0.0 if offset is None else offset) * self._unit_m
        masked = self._band.GetMaskFlags() & (gdal.GMF_PER_DATASET | gdal.GMF_ALPHA)
        self._mask = self._band.GetMaskBand() if masked else None

    @cached_property
    def state(self):
        """Everything by which a kept result notices that the DEM is another one, or is read in another way."""
        files = dataset_state(self.path, self._dataset)
        return (files, self.band, self.shape, self.geotransform, self.crs_wkt, self.nodata, self._scale, self._offset,
                self.reading.nodata_ranges)  # fmt: skip

    @property
    def description(self):
        """Name of the band in its file."""
        return self._band.GetDescription() or ""

    @property
    def block_rows(self):
        """Rows of a block of the file."""
        return self._band.GetBlockSize()[1]

    @property
    def highest_value(self):
        """Value of the band above which a cell counts as nodata."""
        return (PLAUSIBLE_M[1] - self._offset) / self._scale if self._scale > 0 else np.inf

    def raw_sample(self):
        """Give the finite values of the band in evenly spread windows, also those that count as nodata."""
        values = []
        with quiet_gdal():
            for window in windows(self.shape):
                try:
                    cells = self._band.ReadAsArray(window.col, window.row, window.cols, window.rows)
                except RuntimeError:
                    cells = None
                values.append(np.zeros(0) if cells is None else cells.astype(float).ravel())
        values = np.concatenate(values)
        return values[np.isfinite(values) & (values != float(self._fill))]

    def __reduce__(self):
        """Pickle as the path, so that another process opens the file itself."""
        return open_dem, (self.source, self.band, self.crs_wkt, self.reading)

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
        with small_cache(bytes_of_block_row(self._dataset, self._band, window.cols)):
            for start in range(0, window.rows if window.cols else 0, strip_rows):
                strip = out[start : start + strip_rows]
                self._read_strip(window.col, window.row + start, strip)

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
        if hidden is None and any(self._surely_valid(*limits) for limits in _ranges(strip)):
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
        if self.reading.nodata_ranges:
            void |= in_ranges(strip, self.reading.nodata_ranges, self._unit_m)
        with np.errstate(invalid="ignore"):
            void |= (strip <= PLAUSIBLE_M[0]) | (strip >= PLAUSIBLE_M[1])
        strip[void] = np.nan

    def _surely_valid(self, lowest, highest):
        """Tell whether no value in this range needs an individual check, which saves six of eight passes."""
        plausible = PLAUSIBLE_M[0] < lowest and highest < PLAUSIBLE_M[1]  # False for NaN too
        fill = lowest <= self._fill <= highest or lowest <= COMMON_FILL <= highest
        zero = self.zero_is_void and lowest <= 0 <= highest or self.reading.nodata_ranges
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


def _ranges(strip):
    """Ranges that hold all values: if nothing is void or below 0, one that takes a single pass; then the exact one.

    The exact range is NaN if anything is void.
    """
    bits = strip.view(np.uint32)  # as whole numbers, floats from 0 keep their order, and all others are larger
    highest = bits.max(axis=1).max() if strip.shape[1] >= LONG_ROW else bits.max()
    if highest < INFINITY_BITS:
        yield 0.0, float(highest.view(np.float32))
    yield float(strip.min()), float(strip.max())
