"""The index of an area on disk, and photographs that cannot be searched; the search itself: tests/core/locate."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import SkylineNotFoundError
from skyline_viewshed.core.base.model import Photo, PhotoMetadata
from skyline_viewshed.core.batch import PhotoRequest
from skyline_viewshed.core.io.dem_reading import DemReading
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.locate.answer import Known
from skyline_viewshed.core.locate.places import Area, AreaError, IndexOptions
from skyline_viewshed.core.locating import index_of_area, locate, locate_request
from skyline_viewshed.core.searching import lens
from skyline_viewshed.core.skyline.given import evidence_from_line
from skyline_viewshed.demo.dem_file import write_dem

SMALL = IndexOptions(spacing_m=400.0, azimuths=360, max_distance_m=4_000.0)
METRES_PER_FOOT = 0.3048


@pytest.fixture(scope="module")
def dem_path(tmp_path_factory):
    row, col = np.mgrid[:60, :60]
    path = str(tmp_path_factory.mktemp("locating") / "dem.tif")
    write_dem(path, (500 + 20 * np.hypot(row - 30, col - 30)).astype(np.float32), 90.0, 8.0, 46.5)
    return path


@pytest.fixture(scope="module")
def area():
    return Area.circle(8.0, 46.5, 1_200.0)


def test_an_index_is_kept_for_the_dem_as_it_was_read(dem_path, area, tmp_path):
    metres = index_of_area(open_dem(dem_path), area, SMALL, str(tmp_path))
    feet = index_of_area(open_dem(dem_path, reading=DemReading(unit="feet")), area, SMALL, str(tmp_path))
    assert feet.ground_m == pytest.approx(metres.ground_m * METRES_PER_FOOT, rel=1e-4)
    assert len(list(tmp_path.iterdir())) == 2


def test_the_limit_of_memory_makes_no_other_index(dem_path, area, tmp_path):
    for memory_mb in (0.001, 1.0):  # on disk there is no limit
        options = IndexOptions(SMALL.spacing_m, 1.7, 360, 4_000.0, 0.13, memory_mb)
        index_of_area(open_dem(dem_path), area, options, str(tmp_path))
    assert len(list(tmp_path.iterdir())) == 1
    with pytest.raises(AreaError, match="MB"):
        index_of_area(open_dem(dem_path), area, IndexOptions(SMALL.spacing_m, 1.7, 360, 4_000.0, 0.13, 0.001))


def test_an_unreadable_photograph_fails_with_its_reason(dem_path, area, tmp_path):
    dem = open_dem(dem_path)
    found = locate_request(PhotoRequest(str(tmp_path / "missing.jpg")), (dem, index_of_area(dem, area, SMALL)))
    assert found.status == "failed" and "cannot be read" in found.message and found.places == ()


def test_a_picture_with_hardly_any_skyline_is_refused(dem_path, area):
    dem, metadata = open_dem(dem_path), PhotoMetadata("a.jpg", 400, 300)
    evidence = evidence_from_line(np.arange(20.0), np.full(20, 90.0), 400, 300)
    photo, terrain = Photo(metadata, np.zeros((300, 400, 3), np.uint8)), (dem, index_of_area(dem, area, SMALL))
    with pytest.raises(SkylineNotFoundError, match="Hardly any column"):
        locate(photo, evidence, lens(metadata, 50.0, (30.0, 75.0)), terrain)


def test_places_that_the_weights_exclude_are_not_found(dem_path, area):
    dem, metadata = open_dem(dem_path), PhotoMetadata("a.jpg", 400, 300)
    index = index_of_area(dem, area, SMALL)
    column = np.arange(400.0)
    evidence = evidence_from_line(column, 120 + 10 * np.sin(column / 30), 400, 300)
    photo = Photo(metadata, np.zeros((300, 400, 3), np.uint8))
    weight = np.where(index.longitude_deg < 8.0, 0.0, -np.inf)
    found = locate(photo, evidence, lens(metadata, 50.0, (30.0, 75.0)), (dem, index), known=Known(None, weight))
    step_deg = 1.1 * index.spacing_m / 76_500  # the best places are moved by less than a step of the grid
    assert found.places and all(place.longitude_deg < 8.0 + step_deg for place in found.places)
    assert (index.longitude_deg[found.region] < 8.0).all()
    best = found.places[0]
    east = (index.longitude_deg - best.longitude_deg) * np.cos(np.radians(46.5))
    away = np.where(index.longitude_deg < 8.0, np.hypot(east, index.latitude_deg - best.latitude_deg), np.inf)
    assert int(away.argmin()) in found.region  # also if the answer was moved to another cell
