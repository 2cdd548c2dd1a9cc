"""Build the index of an area, tile by tile."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from ..base.messages import Message
from ..base.progress import SILENT, checkpoint, subtask
from .index import HorizonIndex, stored_angles, stored_distances
from .many import CellGrid, ManyOptions, many_horizons
from .places import AreaError, IndexOptions, PlaceGrid, check_memory, lay_places

STORED = ("place", "elevation", "distance", "sizes")
"""Names of the arrays of an index in a store."""


@dataclass(frozen=True, eq=False)
class TileWork:
    """Computes the horizons of the places of a tile, here or in another process; picklable if its DEM is.

    Attributes
    ----------
    dem : core.io.raster.Dem or core.base.terrain.ArrayTerrain
    grid : PlaceGrid
        Without its tiles.
    options : IndexOptions
    """

    dem: Any
    grid: PlaceGrid
    options: IndexOptions

    def __call__(self, tile, progress=SILENT):
        """Give place (3, K), elevation and distance (K, A) as they are stored, and the size of the DEM's cells [m]."""
        options, grid = self.options, self.grid
        cells = CellGrid(tile.row, tile.col, tile.rows, tile.cols, grid.step_rows, grid.step_cols)
        middle = self.dem.position_of(*cells.middle_px)
        frame = self.dem.frame(float(middle[0]), float(middle[1]), options.max_distance_m)
        many = ManyOptions(options.azimuths, options.max_distance_m, options.refraction_coefficient)
        found = many_horizons(self.dem, frame, cells, options.eye_height_m, many, progress)
        usable = np.flatnonzero(tile.inside & np.isfinite(found.ground_m))
        place = np.vstack([*self.dem.position_of(*cells.places_px), found.ground_m])[:, usable]
        return (
            place,
            stored_angles(found.elevation_deg[usable]),
            stored_distances(found.distance_m[usable]),
            frame.cell_m,
        )


def one_after_the_other(work, tiles, progress):
    """Yield what `work` gives for each tile, computed in this process.

    Parameters
    ----------
    work : TileWork
    tiles : sequence of Tile
    progress : Progress
    """
    for number, tile in enumerate(tiles):
        yield work(tile, subtask(progress, number / len(tiles), (number + 1) / len(tiles)))


# parameters: an area on a DEM, and where its index is computed and held
def build_index(dem, area, options=IndexOptions(), hold=None, progress=SILENT, spread=one_after_the_other):  # noqa: B008
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
    spread : callable
        (TileWork, tiles, progress) -> iterator over what the work gives for each tile, in order.

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
    elevation = hold("elevation", (grid.count, options.azimuths), np.int16)
    distance = hold("distance", (grid.count, options.azimuths), np.uint16)
    place, cell_m = hold("place", (3, grid.count), np.float64), None
    place[:] = np.nan
    first = 0
    for found in spread(TileWork(dem, replace(grid, tiles=()), options), grid.tiles, progress):
        last = first + found[0].shape[1]
        place[:, first:last], elevation[first:last], distance[first:last] = found[:3]
        cell_m = cell_m or found[3]
        first = last
    if not first:
        raise AreaError(
            Message("The DEM has no heights in the area. Choose another area, or a DEM without voids there.")
        )
    hold("sizes", (2,), np.float64)[:] = cell_m, grid.spacing_m
    checkpoint(progress, 1.0)
    return index_of({"place": place, "elevation": elevation, "distance": distance, "sizes": (cell_m, grid.spacing_m)})


# parameters: as for `build_index`, and the store
def kept_index(dem, area, options, store, progress=SILENT, spread=one_after_the_other):
    """The index of an area from a store, which is filled if it is empty.

    Parameters
    ----------
    dem, area, options, progress, spread
        As for `build_index`.
    store : core.io.array_folder.ArrayFolder or None
        For this DEM, area and options; None holds the index in memory.
    """
    if store is None:
        return build_index(dem, area, options, None, progress, spread)
    kept = store.read(STORED)
    if kept is None:
        with store.filling() as hold:
            build_index(dem, area, options, hold, progress, spread)
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
