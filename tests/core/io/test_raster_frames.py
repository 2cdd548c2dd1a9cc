"""Frames of elevation models: true directions and distances in any CRS, by geodesics computed here."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from rasters import make_tif
from skyline_viewshed.core.base.errors import ObserverOutsideDemError
from skyline_viewshed.core.base.terrain import ground_elevation_m
from skyline_viewshed.core.io.crs import from_wgs84
from skyline_viewshed.core.io.raster import open_dem


def vincenty_direct(longitude_deg, latitude_deg, azimuth_deg, distance_m):
    """Geodesic from a point on WGS 84 (Vincenty 1975, Survey Review XXIII 176): (longitude, latitude) [degrees]."""
    a, f = 6_378_137.0, 1 / 298.257223563
    b, azimuth = a * (1 - f), np.radians(azimuth_deg)
    u1 = np.arctan((1 - f) * np.tan(np.radians(latitude_deg)))
    sigma1 = np.arctan2(np.tan(u1), np.cos(azimuth))
    sin_alpha = np.cos(u1) * np.sin(azimuth)
    cos2_alpha = 1 - sin_alpha**2
    u2 = cos2_alpha * (a**2 - b**2) / b**2
    big_a = 1 + u2 / 16384 * (4096 + u2 * (-768 + u2 * (320 - 175 * u2)))
    big_b = u2 / 1024 * (256 + u2 * (-128 + u2 * (74 - 47 * u2)))
    sigma = distance_m / (b * big_a)
    for _ in range(50):
        middle = np.cos(2 * sigma1 + sigma)
        change = (
            big_b
            * np.sin(sigma)
            * (
                middle
                + big_b
                / 4
                * (
                    np.cos(sigma) * (2 * middle**2 - 1)
                    - big_b / 6 * middle * (4 * np.sin(sigma) ** 2 - 3) * (4 * middle**2 - 3)
                )
            )
        )
        sigma = distance_m / (b * big_a) + change
    sin_u1, cos_u1, sin_s, cos_s = np.sin(u1), np.cos(u1), np.sin(sigma), np.cos(sigma)
    latitude = np.arctan2(
        sin_u1 * cos_s + cos_u1 * sin_s * np.cos(azimuth),
        (1 - f) * np.hypot(sin_alpha, sin_u1 * sin_s - cos_u1 * cos_s * np.cos(azimuth)),
    )
    turn = np.arctan2(sin_s * np.sin(azimuth), cos_u1 * cos_s - sin_u1 * sin_s * np.cos(azimuth))
    c = f / 16 * cos2_alpha * (4 + f * (4 - 3 * cos2_alpha))
    middle = np.cos(2 * sigma1 + sigma)
    turn -= (1 - c) * f * sin_alpha * (sigma + c * sin_s * (middle + c * cos_s * (2 * middle**2 - 1)))
    return longitude_deg + np.degrees(turn), np.degrees(latitude)


CUSTOM = "+proj=tmerc +lat_0=0 +lon_0=-146 +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m"

PLACES = [
    ("EPSG:32606", -149.5, 61.1),
    ("EPSG:3413", -149.5, 61.1),
    ("EPSG:3031", 78.25, -68.47),
    ("EPSG:3857", 6.5, 43.5),
    ("EPSG:3857", -149.5, 61.1),
    ("EPSG:4326", -149.5, 61.1),
    ("EPSG:4326", 86.83, 27.89),
    ("EPSG:4326", 15.0, 78.2),
    ("EPSG:4326", 179.9, -16.8),
    ("EPSG:4326", -179.9, 66.0),
    ("EPSG:3857", 179.9, -16.8),
    ("EPSG:32701", -179.95, -16.8),
    (CUSTOM, -147.0, 61.2),
]


def dem_around(tmp_path, crs, longitude_deg, latitude_deg, cell_m=50.0, south_up=False, side=64):
    """Small raster whose middle lies at a place; cells of about `cell_m`, non-square in degrees."""
    x, y = from_wgs84(crs, longitude_deg, latitude_deg)
    if crs == "EPSG:4326":
        cell_x, cell_y = cell_m / 111_320 / np.cos(np.radians(latitude_deg)), cell_m / 111_320
    else:
        cell_x, cell_y = cell_m, 1.25 * cell_m
    sign = -1 if south_up else 1
    transform = (x - side / 2 * cell_x, cell_x, 0, y + sign * side / 2 * cell_y, 0, -sign * cell_y)
    return open_dem(make_tif(tmp_path / "dem.tif", np.full((side, side), 500, np.float32), transform, crs))


def wrapped_distance_m(dem, crs, col, row, longitude_deg, latitude_deg):
    """Ground distance between pixels and positions, modulo turns of the world [m], by small-angle arithmetic."""
    found_longitude, found_latitude = dem.position_of(col, row)
    turn = (found_longitude - longitude_deg + 180) % 360 - 180
    return 111_320 * np.hypot(found_latitude - latitude_deg, turn * np.cos(np.radians(latitude_deg)))


@pytest.mark.parametrize("crs, longitude_deg, latitude_deg", PLACES)
def test_frame_follows_geodesics_in_any_crs(tmp_path, crs, longitude_deg, latitude_deg):
    dem = dem_around(tmp_path, crs, longitude_deg, latitude_deg)
    radius_m = 60_000.0
    frame = dem.frame(longitude_deg, latitude_deg, radius_m)
    azimuth_deg, distance_m = np.meshgrid(np.arange(0, 360, 15.0) + 3.7, [50.0, 1000, 12_345, 40_000, 59_000])
    azimuth = np.radians(azimuth_deg)
    col, row = frame.to_pixel(distance_m * np.sin(azimuth), distance_m * np.cos(azimuth))
    expected = vincenty_direct(longitude_deg, latitude_deg, azimuth_deg, distance_m)
    error_m = wrapped_distance_m(dem, crs, col, row, *expected)
    # Interpolation costs at most 0.1 m here, in longitude and latitude at 78 degrees north (measured; 1.1 m at 200 km).
    assert error_m.max() < 0.3


@pytest.mark.parametrize("crs, longitude_deg, latitude_deg", PLACES)
def test_frame_goes_both_ways(tmp_path, crs, longitude_deg, latitude_deg):
    frame = dem_around(tmp_path, crs, longitude_deg, latitude_deg).frame(longitude_deg, latitude_deg, 30_000.0)
    east_m, north_m = np.array([-20_000.0, 300, 15_000]), np.array([5000.0, -12_000, 21_000])
    back = frame.to_local(*frame.to_pixel(east_m, north_m))
    assert np.allclose(back, (east_m, north_m), atol=0.5)


def test_convergence_of_frames_has_the_standard_sense(tmp_path):
    # The paper adds +104.5 in EPSG:3413 near Anchorage; the standard convergence is its negative.
    for crs, expected_deg in (("EPSG:3413", -104.5), ("EPSG:32606", -2.19), ("EPSG:3857", 0.0), ("EPSG:4326", 0.0)):
        frame = dem_around(tmp_path, crs, -149.5, 61.1).frame(-149.5, 61.1, 1000.0)
        assert frame.convergence_deg == pytest.approx(expected_deg, abs=0.005)


@pytest.mark.parametrize("latitude_deg, longitude_deg", [(46.0, 10.5), (-33.0, 7.5), (61.1, 9.0)])
def test_convergence_of_utm_agrees_with_its_series(tmp_path, latitude_deg, longitude_deg):
    # Snyder 1987, USGS PP 1395, equation 8-16, spherical form plus the ellipsoid's third-order term.
    turn, phi = np.radians(longitude_deg - 9.0), np.radians(latitude_deg)
    eta2 = 0.00673949674 * np.cos(phi) ** 2
    expected = np.degrees(turn * np.sin(phi) * (1 + turn**2 * np.cos(phi) ** 2 * (1 + 3 * eta2 + 2 * eta2**2) / 3))
    zone = "EPSG:32632" if latitude_deg > 0 else "EPSG:32732"
    frame = dem_around(tmp_path, zone, longitude_deg, latitude_deg).frame(longitude_deg, latitude_deg, 1000.0)
    assert frame.convergence_deg == pytest.approx(expected, abs=1e-4)


def test_convergence_of_polar_stereographic_is_the_longitude_itself(tmp_path):
    frame = dem_around(tmp_path, "EPSG:3031", 78.25, -68.5).frame(78.25, -68.5, 1000.0)
    assert frame.convergence_deg == pytest.approx(-78.25, abs=1e-4)


def test_cell_sizes_are_ground_metres(tmp_path):
    frame = dem_around(tmp_path, "EPSG:3857", -149.5, 61.1).frame(-149.5, 61.1, 1000.0)
    # Mercator's scale at 61.1 N is 1 / cos up to the ellipsoid's fraction of a percent.
    assert frame.cell_size_m == pytest.approx(
        (50 * np.cos(np.radians(61.1)), 62.5 * np.cos(np.radians(61.1))), rel=0.006
    )
    polar = dem_around(tmp_path, "EPSG:3413", -149.5, 61.1).frame(-149.5, 61.1, 1000.0)
    assert polar.cell_size_m == pytest.approx((50 / 1.035, 62.5 / 1.035), rel=0.002)


def test_south_up_rasters_give_the_same_ground(tmp_path):
    place = ("EPSG:32606", -149.5, 61.1)
    upright, flipped = dem_around(tmp_path, *place), None
    frame = upright.frame(-149.5, 61.1, 5000.0)
    flipped = dem_around(tmp_path, *place, south_up=True).frame(-149.5, 61.1, 5000.0)
    col, row = frame.to_pixel(700.0, 900.0)
    assert flipped.to_pixel(700.0, 900.0) == pytest.approx((col, 63 - row), abs=1e-6)
    assert flipped.convergence_deg == pytest.approx(frame.convergence_deg, abs=1e-6)


def test_longitudes_from_0_to_360_are_the_same_place(tmp_path):
    values = np.full((100, 100), 900, np.float32)
    dem = open_dem(make_tif(tmp_path / "a.tif", values, (210.0, 0.01, 0, 61.6, 0, -0.01), "EPSG:4326"))
    frame = dem.frame(-149.5, 61.1, 5000.0)
    assert (frame.col_px, frame.row_px) == pytest.approx((49.5, 49.5), abs=1e-6)
    assert ground_elevation_m(dem, frame) == 900


def test_a_raster_across_the_antimeridian_is_whole(tmp_path):
    values = np.tile(np.arange(200, dtype=np.float32), (200, 1)) + 1000
    dem = open_dem(make_tif(tmp_path / "a.tif", values, (179.0, 0.01, 0, -16.0, 0, -0.01), "EPSG:4326"))
    frame = dem.frame(-179.99, -17.0, 40_000.0)  # col 100.5
    west, east = frame.to_pixel(np.array([-30_000.0, 30_000.0]), 0.0)[0]
    assert west == pytest.approx(100.5 - 28.2, abs=0.3)
    assert east == pytest.approx(100.5 + 28.2, abs=0.3)


def test_a_place_beyond_the_crs_or_the_raster_is_outside(tmp_path):
    dem = dem_around(tmp_path, "EPSG:32606", -149.5, 61.1)
    with pytest.raises(ObserverOutsideDemError):
        ground_elevation_m(dem, dem.frame(-120.0, 61.1, 5000.0))
    with pytest.raises(ObserverOutsideDemError):
        ground_elevation_m(dem, dem.frame(31.0, 1.0, 5000.0))


def test_the_observers_place_within_a_cell_counts(tmp_path):
    dem = dem_around(tmp_path, "EPSG:32606", -149.5, 61.1)
    here, there = dem.frame(-149.5, 61.1, 1000.0), dem.frame(-149.4999, 61.1, 1000.0)
    shift_m = 0.0001 * 111_320 * np.cos(np.radians(61.1))
    assert np.hypot((there.col_px - here.col_px) * 50, (there.row_px - here.row_px) * 62.5) == pytest.approx(
        shift_m, rel=0.01
    )


@settings(max_examples=40, deadline=None, derandomize=True, database=None)
@given(st.floats(0, 647), st.floats(0, 647))
def test_pixels_and_positions_are_inverse(khumbu, col_px, row_px):
    assert khumbu.pixel_of(*khumbu.position_of(col_px, row_px)) == pytest.approx((col_px, row_px), abs=1e-6)


@pytest.fixture(scope="module")
def khumbu(shared_data):
    return open_dem(shared_data / "khumbu/dem/khumbu.tif")
