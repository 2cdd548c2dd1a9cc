"""Viewsheds, polygons, probabilities and sky views across 180 degrees are those of the same ground elsewhere."""

from functools import cache

import numpy as np
import pytest
from osgeo import gdal, ogr, osr
from reference.landscapes import fractal
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px
from skyline_viewshed.core.base.posed import PosedPhoto
from skyline_viewshed.core.base.terrain import Observer, Window
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.horizon.sky_view import SkyViewOptions, sky_view_raster
from skyline_viewshed.core.io.crs import from_wgs84
from skyline_viewshed.core.io.polygons import viewshed_polygons
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.viewshed.layers import layers
from skyline_viewshed.core.viewshed.probability import visibility_probability
from skyline_viewshed.core.viewshed.viewshed import FullCircle, PhotoFrame, ViewshedOptions, Wedge, viewshed

SIZE, CELL_DEG, LATITUDE = 240, 0.0005, -17.0
OPTIONS = ViewshedOptions(max_distance_m=5_000.0)
CAMERA = Camera(800, 600, focal_of_fov_px(800, 60.0))
SECTORS = {"circle": FullCircle(), "wedge": Wedge(80.0, 120.0), "frame": PhotoFrame(CAMERA, Pose(265.0, -6.0, 1.0))}
HOME_DEG = 20.0
EYE_M = 700.0


def write(path, centre_deg, crs="EPSG:4326"):
    """The same mountains around a longitude of the raster's own turn of the world."""
    reference = osr.SpatialReference()
    reference.SetFromUserInput(crs)
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), SIZE, SIZE, 1, gdal.GDT_Float32)
    dataset.SetProjection(reference.ExportToWkt())
    half = SIZE / 2 * CELL_DEG
    if crs == "EPSG:4326":
        dataset.SetGeoTransform((centre_deg - half, CELL_DEG, 0, LATITUDE + half, 0, -CELL_DEG))
    else:  # Mercator: x grows with longitude beyond the edge of the world
        per_degree = 20037508.342789244 / 180
        _, y = from_wgs84(crs, 0.0, LATITUDE)
        cell = CELL_DEG * per_degree
        dataset.SetGeoTransform((centre_deg * per_degree - SIZE / 2 * cell, cell, 0, y + SIZE / 2 * cell, 0, -cell))
    dataset.GetRasterBand(1).WriteArray(fractal(SIZE, 8, relief_m=600.0))
    dataset = None
    return open_dem(str(path))


@pytest.fixture(scope="module")
def ground(tmp_path_factory):
    """Give the raster around a longitude in a CRS; each is written once."""

    @cache
    def raster(crs, centre_deg):
        return write(tmp_path_factory.mktemp("ground") / "dem.tif", centre_deg, crs)

    return raster


def at_home(shift_deg=0.0):
    return Observer(HOME_DEG + shift_deg, LATITUDE, eye_elevation_m=EYE_M)


GLOBE, PLANE = "EPSG:4326", "EPSG:3857"
EAST, WEST, BEFORE, BEYOND = (0.0, 180.0), (0.0, -180.0), (-0.004, 179.996), (0.004, -179.996)
"""Shift from the middle, and the longitude that a receiver reports for it."""
CASES = [
    ("circle", EAST, GLOBE, 180.0),
    ("circle", WEST, PLANE, -180.0),
    ("circle", BEYOND, GLOBE, -180.0),
    ("circle", BEFORE, PLANE, 180.0),
    ("wedge", EAST, PLANE, -180.0),
    ("wedge", WEST, GLOBE, 180.0),
    ("wedge", BEYOND, PLANE, 180.0),
    ("wedge", BEFORE, GLOBE, -180.0),
    ("frame", EAST, PLANE, 180.0),
    ("frame", WEST, GLOBE, -180.0),
    ("frame", BEYOND, GLOBE, 180.0),
    ("frame", BEFORE, PLANE, -180.0),
]
"""Each sector with each place, and each sector with each raster (CRS, longitude of its middle), once."""


@pytest.mark.parametrize(("name", "place", "crs", "centre_deg"), CASES)
def test_the_ground_in_view_is_the_same_cells(ground, name, place, crs, centre_deg):
    home, there, sector = ground(crs, HOME_DEG), ground(crs, centre_deg), SECTORS[name]
    shift, longitude = place
    expected = viewshed(home, at_home(shift), sector, OPTIONS)
    found = viewshed(there, Observer(longitude, LATITUDE, eye_elevation_m=EYE_M), sector, OPTIONS)
    assert found.window == expected.window and expected.visible.sum() > 300
    assert (found.values != expected.values).sum() <= 3  # the tables of a place differ in the twelfth digit
    ours, theirs = viewshed_polygons(found, there), viewshed_polygons(expected, home)
    assert ours.area_m2 == pytest.approx(theirs.area_m2, rel=1e-3)
    assert ours.farthest_m == pytest.approx(theirs.farthest_m, abs=60.0)
    shape = ogr.CreateGeometryFromWkb(ours.wkb)
    assert shape.IsValid()
    left, right, _, _ = shape.GetEnvelope()
    x0, dx = there.geotransform[:2]
    assert x0 <= left < right <= x0 + dx * SIZE, "in one piece, where the raster is"


@pytest.mark.parametrize("centre_deg", [180.0, -180.0])
@pytest.mark.parametrize("crs", [GLOBE, PLANE])
def test_layers_horizon_probabilities_and_sky_views_are_the_same(ground, crs, centre_deg):
    home, there = ground(crs, HOME_DEG), ground(crs, centre_deg)
    shift, longitude = BEYOND
    eye = Observer(longitude, LATITUDE, eye_elevation_m=EYE_M)
    frame = SECTORS["frame"]
    for (_, ours), (_, theirs) in zip(
        layers(there, viewshed(there, eye, frame, OPTIONS), PosedPhoto(CAMERA, frame.pose, eye)),
        layers(home, viewshed(home, at_home(shift), frame, OPTIONS), PosedPhoto(CAMERA, frame.pose, eye)),
    ):
        np.testing.assert_allclose(ours["distance_m"], theirs["distance_m"], atol=0.05)
        np.testing.assert_allclose(ours["column_px"], theirs["column_px"], atol=0.5, rtol=1e-3)
    options = HorizonOptions(azimuth_step_deg=1.0, max_distance_m=5_000.0)
    ours, theirs = horizon_profile(there, eye, options), horizon_profile(home, at_home(shift), options)
    np.testing.assert_allclose(ours.elevation_deg, theirs.elevation_deg, atol=1e-4)
    chances = [
        visibility_probability(dem, PosedPhoto(CAMERA, frame.pose, place), OPTIONS)
        for dem, place in ((there, eye), (home, at_home(shift)))
    ]
    assert chances[0].window == chances[1].window
    assert np.abs(chances[0].values - chances[1].values).max() < 0.1
    assert chances[0].area_m2(0.5) == pytest.approx(chances[1].area_m2(0.5), rel=0.01) and chances[0].area_m2(0.5) > 0
    tile, sky = Window(100, 100, 16, 16), SkyViewOptions(azimuths=8, max_distance_m=2_000.0)
    views = [next(iter(sky_view_raster(dem, tile, sky)))[1] for dem in (there, home)]
    np.testing.assert_allclose(*views, atol=1e-4)


def test_a_raster_of_the_whole_globe_ends_at_its_seam(tmp_path):
    """As documented: a frame follows the ground across 180 degrees, a raster that ends there does not."""
    path = tmp_path / "globe.tif"
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), 3600, 1800, 1, gdal.GDT_Float32)
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(4326)
    dataset.SetProjection(reference.ExportToWkt())
    dataset.SetGeoTransform((-180, 0.1, 0, 90, 0, -0.1))
    dataset.GetRasterBand(1).Fill(200.0)
    dataset = None
    dem = open_dem(str(path))
    eye = Observer(179.95, 10.05, eye_elevation_m=2_000.0)
    found = viewshed(dem, eye, options=ViewshedOptions(max_distance_m=80_000.0))
    assert found.window.col + found.window.cols == 3600 and found.visible[:, -1].any()
