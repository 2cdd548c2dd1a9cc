import numpy as np
import pytest
from skyline_viewshed.core.base.errors import TerrainError
from skyline_viewshed.core.io.crs import (
    Transformer,
    from_wgs84,
    local_plane,
    spatial_reference,
    to_wgs84,
    x_period,
)


@pytest.mark.parametrize("crs", ["EPSG:3413", "EPSG:32606", "EPSG:3857", "EPSG:4326"])
def test_round_trip(crs):
    longitude_deg, latitude_deg = np.array([-150.0, -149.2]), np.array([61.0, 61.3])
    x, y = from_wgs84(crs, longitude_deg, latitude_deg)
    back = to_wgs84(crs, x, y)
    assert np.allclose(back, (longitude_deg, latitude_deg), atol=1e-9)


def test_axes_are_longitude_first():
    assert from_wgs84("EPSG:4326", 8.0, 46.0) == pytest.approx((8.0, 46.0))


def test_swiss_grid_at_its_origin():
    # The old observatory of Berne is E 600000, N 200000 of CH1903 / LV03.
    assert from_wgs84("EPSG:21781", 7.438632, 46.951083) == pytest.approx((600_000, 200_000), abs=2.0)


def test_what_lies_outside_the_domain_is_nan():
    x, y = from_wgs84("EPSG:3857", np.array([0.0, 0.0]), np.array([-90.0, 10.0]))
    assert np.isnan(y[0]) or abs(y[0]) > 1e8
    assert np.isfinite([x[1], y[1]]).all()


def test_heights_of_a_compound_crs_are_left_out():
    flat = from_wgs84("EPSG:32632", 8.0, 46.0)
    assert from_wgs84("EPSG:32632+5773", 8.0, 46.0) == pytest.approx(flat, abs=1e-6)


def test_a_local_plane_measures_true_azimuth_and_distance():
    longitude_deg, latitude_deg = Transformer(local_plane(86.8, 27.9), "EPSG:4326")(0.0, 10_000.0)
    assert longitude_deg == pytest.approx(86.8, abs=1e-9)
    # 1 degree of meridian at 27.945 N is 110.82 km (WGS 84).
    assert latitude_deg - 27.9 == pytest.approx(10_000 / 110_821, rel=1e-4)


@pytest.mark.parametrize(
    "crs, period",
    [
        ("EPSG:4326", 360.0),
        ("EPSG:3857", 40_075_016.686),
        ("EPSG:32606", None),
        ("EPSG:3031", None),
        ("EPSG:3413", None),
    ],
)
def test_only_cylindrical_planes_repeat_the_world(crs, period):
    assert x_period(crs) == (None if period is None else pytest.approx(period, rel=1e-9))


def test_nonsense_is_refused_in_a_sentence():
    with pytest.raises(TerrainError, match="not recognised"):
        spatial_reference("EPSG:999999")


@pytest.mark.parametrize("crs", ["EPSG:32606", "EPSG:25832", "EPSG:2056", "EPSG:27700", "EPSG:3031", "EPSG:4326"])
def test_wgs84_is_that_of_ogc(crs):
    """EPSG:4326, found faster by PROJ, in the order of OGC:CRS84."""
    longitude, latitude = np.array([8.0, 8.3]), np.array([46.5, 46.2])
    x, y = Transformer("OGC:CRS84", crs)(longitude, latitude)
    assert np.allclose(from_wgs84(crs, longitude, latitude), (x, y), atol=1e-6, rtol=0)
    assert np.allclose(to_wgs84(crs, x, y), Transformer(crs, "OGC:CRS84")(x, y), atol=1e-11, rtol=0)
