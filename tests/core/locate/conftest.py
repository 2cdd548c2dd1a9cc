"""Peaks on a plain, and the skyline that a camera sees of them, drawn exactly."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera, focal_of_fov_px
from skyline_viewshed.core.base.model import Photo, PhotoMetadata
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.locate.build import build_index
from skyline_viewshed.core.locate.places import Area, IndexOptions
from skyline_viewshed.core.locating import locate
from skyline_viewshed.core.match.geometry import HorizonCurve, horizon_rows
from skyline_viewshed.core.searching import LocateOptions, lens
from skyline_viewshed.core.skyline.given import evidence_from_line

CELL_M, SIZE = 100.0, 160
WIDTH, HEIGHT, HFOV_DEG = 400, 300, 60.0

CONE = ((8_000, 8_000, 1_200, 3_000),)
UNLIKE = ((6_500, 9_000, 1_500, 3_000), (10_500, 6_500, 900, 2_200), (12_000, 9_500, 1_200, 1_500))
"""(x, y, height, radius) of cones on the plain [m]; y to the south."""


def peaks(cones):
    """A plain with cones."""
    row, col = np.mgrid[:SIZE, :SIZE] * CELL_M
    height = np.zeros((SIZE, SIZE))
    for x, y, top, radius in cones:
        height = np.maximum(height, top * np.maximum(0, 1 - np.hypot(col - x, row - y) / radius))
    return ArrayTerrain(height.astype(np.float32), CELL_M, 8.0, 46.0)


def whole(terrain, margin=3):
    """The whole terrain but for a margin, as an area."""
    rows, cols = terrain.shape
    west, north = terrain.position_of(margin, margin)
    east, south = terrain.position_of(cols - 1 - margin, rows - 1 - margin)
    return Area.box(float(west), float(south), float(east), float(north))


def skyline_from(terrain, col, row, heading_deg, pitch_deg=2.0):
    """Evidence of the skyline from a cell, drawn by the exact engine."""
    longitude, latitude = terrain.position_of(col, row)
    observer = Observer(float(longitude), float(latitude))
    camera = Camera(WIDTH, HEIGHT, focal_of_fov_px(WIDTH, HFOV_DEG))
    curve = HorizonCurve(horizon_profile(terrain, observer, HorizonOptions(0.1, 25_000.0)))
    column = np.arange(WIDTH)
    rows = horizon_rows(curve, camera, np.array([[heading_deg, pitch_deg, 0.0, 0.0, 0.0]]), column)[0][0]
    known = np.isfinite(rows)
    return evidence_from_line(column[known], rows[known], WIDTH, HEIGHT)


@dataclass(frozen=True, eq=False)
class Search:
    """A search for the place of one drawn skyline, and its answer."""

    terrain: ArrayTerrain
    index: object
    found: object
    true_px: tuple

    def away_m(self, place):
        """Distance of a place from the true one [m]."""
        col, row = self.terrain.pixel_of(place.longitude_deg, place.latitude_deg)
        return float(np.hypot(col - self.true_px[0], row - self.true_px[1]) * CELL_M)


def search(cones, hfov_deg=HFOV_DEG, true_px=(80, 145)):
    """Search the plain for the place of a skyline that was drawn looking north."""
    terrain = peaks(cones)
    ray = {"azimuths": 360, "max_distance_m": 15_000.0}
    options = LocateOptions.of(IndexOptions(spacing_m=500.0, **ray), (45.0, 70.0), 0.0)
    index = build_index(terrain, whole(terrain), options.index)
    metadata = PhotoMetadata("drawn.jpg", WIDTH, HEIGHT)
    photo = Photo(metadata, np.zeros((HEIGHT, WIDTH, 3), np.uint8))
    evidence = skyline_from(terrain, *true_px, 0.0)
    found = locate(photo, evidence, lens(metadata, hfov_deg, (45.0, 70.0)), (terrain, index), options)
    return Search(terrain, index, found, true_px)


@pytest.fixture(scope="session")
def cone():
    """Terrain with a single cone."""
    return peaks(CONE)


@pytest.fixture(scope="session")
def cone_search():
    """The search below a single cone."""
    return search(CONE)


@pytest.fixture(scope="session")
def unlike_search():
    """The search below peaks that are unlike."""
    return search(UNLIKE)


@pytest.fixture(scope="session")
def area_of():
    """Give the area of a whole terrain."""
    return whole
