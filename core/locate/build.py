"""Build the index of an area, tile by tile."""

from __future__ import annotations

import numpy as np

from ..base.messages import Message
from ..base.progress import SILENT, checkpoint, subtask
from .index import HorizonIndex, stored_angles, stored_distances
from .many import CellGrid, ManyOptions, many_horizons
from .places import AreaError, IndexOptions, check_memory, lay_places

STORED = ("place", "elevation", "distance", "sizes")
"""Names of the arrays of an index in a store."""


def build_index(dem, area, options=IndexOptions(), hold=None, progress=SILENT):  # noqa: B008 - frozen
    """Compute the horizons of all places of an area.

    Parameters
    ----------
    dem : core.io.raster.Dem or core.base.terrain.ArrayTerrain
    area : Area
    options : IndexOptions
    hold : callable or None
        (name, shape, dtype) -> array that is filled, such as one on disk; None holds the index in memory and checks
        first that it fits.
    progress : Progress

    Returns
    -------
    HorizonIndex

    Raises
    ------
    AreaError
        The area lies outside the DEM or in a void of it, or the index is larger than the memory allowed.
    """
    grid = lay_places(dem, area, options)
    if hold is None:
        check_memory(grid, options)
    hold = hold or _in_memory
    many = ManyOptions(options.azimuths, options.max_distance_m, options.refraction_coefficient)
    elevation = hold("elevation", (grid.count, options.azimuths), np.int16)
    distance = hold("distance", (grid.count, options.azimuths), np.uint16)
    place, cell_m = hold("place", (3, grid.count), np.float64), None
    place[:] = np.nan
    first = 0
    for number, tile in enumerate(grid.tiles):
        part = subtask(progress, number / len(grid.tiles), (number + 1) / len(grid.tiles))
        cells = CellGrid(tile.row, tile.col, tile.rows, tile.cols, grid.step_rows, grid.step_cols)
        middle = dem.position_of(*cells.middle_px)
        frame = dem.frame(float(middle[0]), float(middle[1]), options.max_distance_m)
        cell_m = cell_m or frame.cell_m
        found = many_horizons(dem, frame, cells, options.eye_height_m, many, part)
        usable = np.flatnonzero(tile.inside & np.isfinite(found.ground_m))
        last = first + len(usable)
        place[:2, first:last] = np.array(dem.position_of(*cells.places_px))[:, usable]
        place[2, first:last] = found.ground_m[usable]
        elevation[first:last] = stored_angles(found.elevation_deg[usable])
        distance[first:last] = stored_distances(found.distance_m[usable])
        first = last
    if not first:
        raise AreaError(
            Message("The DEM has no heights in the area. Choose another area, or a DEM without voids there.")
        )
    hold("sizes", (2,), np.float64)[:] = cell_m, grid.spacing_m
    checkpoint(progress, 1.0)
    return index_of({"place": place, "elevation": elevation, "distance": distance, "sizes": (cell_m, grid.spacing_m)})


def kept_index(dem, area, options, store, progress=SILENT):
    """The index of an area from a store, which is filled if it is empty.

    Parameters
    ----------
    dem, area, options, progress
        As for `build_index`.
    store : core.io.array_folder.ArrayFolder or None
        For this DEM, area and options; None holds the index in memory.
    """
    if store is None:
        return build_index(dem, area, options, progress=progress)
    kept = store.read(STORED)
    if kept is None:
        with store.filling() as hold:
            build_index(dem, area, options, hold, progress)
        kept = store.read(STORED)
    return index_of(kept)


def index_of(arrays):
    """The `HorizonIndex` of arrays that `build_index` has filled; places in voids of the DEM are left out.

    Parameters
    ----------
    arrays : mapping
        'place', 'elevation', 'distance' and 'sizes'.
    """
    place = np.asarray(arrays["place"])
    count = int(np.isfinite(place[0]).sum())
    cell_m, spacing_m = arrays["sizes"]
    longitude, latitude, ground = place[:, :count]
    elevation, distance = arrays["elevation"][:count], arrays["distance"][:count]
    return HorizonIndex(longitude, latitude, ground, elevation, distance, float(cell_m), float(spacing_m))


def _in_memory(_name, shape, dtype):
    return np.empty(shape, dtype)
