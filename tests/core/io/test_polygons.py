from types import SimpleNamespace

import numpy as np
import pytest
from osgeo import ogr
from skyline_viewshed.core.io.polygons import viewshed_polygons
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.io.write_raster import write_dem
from skyline_viewshed.core.terrain import Window


@pytest.fixture(scope="module")
def dem(tmp_path_factory):
    path = str(tmp_path_factory.mktemp("dem") / "dem.tif")
    write_dem(path, np.full((60, 80), 500.0), 30.0, 8.0, 46.5)
    return open_dem(path)


def seen_of(dem, values, row=0, col=0):
    window = Window(row, col, *values.shape)
    return SimpleNamespace(values=values, window=window, frame=dem.frame(8.0, 46.5, 3000.0))


def test_area_and_parts_of_cells(dem):
    values = np.zeros((20, 30), np.uint8)
    values[2:5, 3:7] = 1
    values[10, 20] = 1
    values[15:18, 0:9] = 255
    ground = viewshed_polygons(seen_of(dem, values, 5, 10), dem)
    shape = ogr.CreateGeometryFromWkb(ground.wkb)
    assert shape.IsValid() and shape.GetGeometryCount() == 2
    assert shape.GetArea() == pytest.approx(13 * 900.0)
    assert ground.area_m2 == pytest.approx(13 * 900.0, rel=1e-4)


def test_cells_that_touch_at_a_corner_make_a_valid_multipolygon(dem):
    values = np.indices((8, 8)).sum(0).astype(np.uint8) % 2
    shape = ogr.CreateGeometryFromWkb(viewshed_polygons(seen_of(dem, values), dem).wkb)
    assert shape.IsValid() and shape.GetGeometryCount() == 32


def test_farthest_ground_is_that_of_a_brute_force_search(dem):
    values = (np.random.default_rng(1).random((60, 80)) < 0.02).astype(np.uint8)
    viewshed = seen_of(dem, values)
    row, col = np.nonzero(values)
    expected = np.hypot(*viewshed.frame.to_local(col, row)).max()
    assert viewshed_polygons(viewshed, dem).farthest_m == pytest.approx(expected)


def test_nothing_seen_gives_no_polygon(dem):
    ground = viewshed_polygons(seen_of(dem, np.zeros((4, 4), np.uint8)), dem)
    assert (ground.wkb, ground.area_m2, ground.farthest_m) == (None, 0.0, None)


def test_small_parts_are_dropped_on_request(dem):
    values = np.zeros((10, 10), np.uint8)
    values[0, 0] = values[5:8, 5:8] = 1
    ground = viewshed_polygons(seen_of(dem, values), dem, smallest_m2=1000.0)
    assert ogr.CreateGeometryFromWkb(ground.wkb).GetGeometryCount() == 1
    assert ground.area_m2 == pytest.approx(8100.0, rel=1e-4)
