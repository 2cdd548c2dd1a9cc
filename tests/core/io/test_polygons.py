from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from osgeo import gdal, ogr, osr
from reference.landscapes import summits, write_summits
from skyline_viewshed.core.base.frame import tabulate_frame
from skyline_viewshed.core.base.terrain import Observer, Window
from skyline_viewshed.core.io import polygons
from skyline_viewshed.core.io.polygons import viewshed_polygons
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.viewshed.viewshed import PackedSink, ViewshedOptions, Wedge, viewshed

CELL_M = 10.0


def utm_wkt():
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(32632)
    return reference.ExportToWkt()


def seen(mask, row=0, col=0):
    """A viewshed of ten-metre cells in UTM 32 at 9 degrees east, 47 north, observer at the first cell."""
    values = np.asarray(mask).astype(np.uint8)
    frame = tabulate_frame(9.0, 47.0, lambda e, n: (e / CELL_M / 0.9996, -n / CELL_M / 0.9996), 50_000.0, size=3)
    grid = SimpleNamespace(crs_wkt=utm_wkt(), geotransform=(500_000.0, CELL_M, 0, 5_205_000.0, 0, -CELL_M))
    return SimpleNamespace(values=values, window=Window(row, col, *values.shape), frame=frame), grid


def geometry(ground):
    return ogr.CreateGeometryFromWkb(ground.wkb)


def test_nothing_in_view_has_no_polygon():
    ground = viewshed_polygons(*seen(np.zeros((5, 7))))
    assert ground.wkb is None
    assert ground.area_m2 == 0
    assert ground.farthest_m is None


def test_a_block_of_cells_keeps_its_outline_and_place():
    mask = np.zeros((30, 30), bool)
    mask[5:15, 10:30] = True
    ground = viewshed_polygons(*seen(mask, row=100, col=50))
    assert geometry(ground).GetEnvelope() == (500_600.0, 500_800.0, 5_203_850.0, 5_203_950.0)
    # On the central meridian a metre of the grid is 1 / 0.9996 of ground.
    assert ground.area_m2 == pytest.approx(10 * 20 * CELL_M**2 / 0.9996**2, rel=1e-4)
    assert ground.farthest_m == pytest.approx(np.hypot(79, 114) * CELL_M * 0.9996, rel=1e-6)


def test_the_farthest_cell_is_that_of_a_search_through_all():
    mask = np.random.default_rng(1).random((60, 80)) < 0.02
    view, grid = seen(mask)
    row, col = np.nonzero(mask)
    assert viewshed_polygons(view, grid).farthest_m == pytest.approx(np.hypot(*view.frame.to_local(col, row)).max())


def test_a_mask_too_large_to_hold_gives_the_same_ground(monkeypatch):
    mask = np.random.default_rng(2).random((90, 70)) < 0.4
    view, grid = seen(mask, row=40, col=3)
    plain = viewshed_polygons(view, grid, smallest_m2=300.0)
    sink = PackedSink(view.window)
    sink.add(view.window, view.values)
    monkeypatch.setattr(polygons, "HELD_CELLS", 100)
    monkeypatch.setattr(polygons, "STRIP_CELLS", 500)
    before = gdal.ReadDir("/vsimem/")
    packed = viewshed_polygons(SimpleNamespace(values=sink.values, window=view.window, frame=view.frame), grid, 300.0)
    assert packed == plain and plain.dropped_m2 > 0
    assert gdal.ReadDir("/vsimem/") == before


def test_unknown_cells_are_not_ground_in_view():
    values = np.full((6, 6), 255)
    values[2, 2] = 1
    assert viewshed_polygons(*seen(values)).area_m2 == pytest.approx(CELL_M**2, rel=1e-2)


def test_a_hole_stays_a_hole_and_a_pinprick_is_filled():
    mask = np.ones((20, 20), bool)
    mask[5:9, 5:9] = False
    mask[15, 15] = False
    shape = geometry(viewshed_polygons(*seen(mask), smallest_m2=2 * CELL_M**2, simplify_cells=0))
    assert shape.GetGeometryRef(0).GetGeometryCount() == 2
    assert shape.GetArea() == pytest.approx((400 - 16) * CELL_M**2)


def test_slivers_below_the_chosen_area_are_dropped_and_counted():
    mask = np.zeros((20, 20), bool)
    mask[2:8, 2:8] = True
    mask[15, 15] = True
    mask[12, 3:6] = True
    whole = viewshed_polygons(*seen(mask), smallest_m2=0)
    large = viewshed_polygons(*seen(mask), smallest_m2=1000.0)
    assert geometry(whole).GetGeometryCount() == 3
    assert geometry(large).GetGeometryCount() == 1
    assert large.dropped_m2 == pytest.approx(4 * CELL_M**2, rel=0.01)


@settings(max_examples=60, deadline=None)
@given(seed=st.integers(0, 10_000), share=st.floats(0.05, 0.95))
def test_any_mask_becomes_a_valid_multipolygon_within_a_cell_of_it(seed, share):
    mask = np.random.default_rng(seed).random((25, 31)) < share
    ground = viewshed_polygons(*seen(mask), smallest_m2=0)
    shape = geometry(ground)
    assert shape.IsValid()
    assert shape.GetGeometryName() == "MULTIPOLYGON"
    exact = geometry(viewshed_polygons(*seen(mask), smallest_m2=0, simplify_cells=0))
    assert exact.GetArea() == pytest.approx(mask.sum() * CELL_M**2)
    assert exact.Buffer(CELL_M).Contains(shape.Buffer(-1e-6))


def test_cells_that_touch_at_a_corner_make_a_valid_multipolygon():
    shape = geometry(viewshed_polygons(*seen(np.indices((8, 8)).sum(0) % 2)))
    assert shape.IsValid()
    assert shape.GetGeometryCount() == 32


def test_diagonal_neighbours_stay_two_parts():
    assert geometry(viewshed_polygons(*seen(np.eye(2)), smallest_m2=0, simplify_cells=0)).GetGeometryCount() == 2


def test_simplifying_by_a_whole_cell_is_refused():
    with pytest.raises(ValueError):
        viewshed_polygons(*seen(np.ones((3, 3))), simplify_cells=1.0)


def test_the_area_is_that_of_the_ellipsoid_in_any_crs(tmp_path):
    """The same mountains in four coordinate systems: grid areas differ up to fourfold, ground areas do not."""
    centre, areas = (-149.5, 61.1), {}
    observer = Observer(*centre, eye_elevation_m=float(summits(*centre, centre)) + 20)
    for crs, cell in (
        ("EPSG:32606", (60, 60)),
        ("EPSG:3413", (60, 60)),
        ("EPSG:3857", (124, 124)),
        ("EPSG:4326", (0.0011, 0.00054)),
    ):
        dem = open_dem(write_summits(tmp_path / f"{crs[5:]}.tif", crs, cell, centre))
        view = viewshed(dem, observer, Wedge(10.0, 150.0), ViewshedOptions(max_distance_m=10_000.0))
        ground = viewshed_polygons(view, dem)
        assert geometry(ground).IsValid()
        assert ground.farthest_m <= 10_000.1
        areas[crs] = ground.area_m2
    reference = areas["EPSG:32606"]
    assert all(area == pytest.approx(reference, rel=0.05) for area in areas.values()), areas
