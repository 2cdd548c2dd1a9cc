import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from reference.landscapes import fractal, stand
from skyline_viewshed.core.base.terrain import ArrayTerrain, Window
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile
from skyline_viewshed.core.horizon.sky_view import (
    SkyViewOptions,
    sky_view_factor,
    sky_view_of_horizon,
    sky_view_raster,
)

AZIMUTH = np.arange(0, 360, 0.5)


def by_quadrature(horizon_deg, slope_deg, aspect_deg):
    """The definition itself: the hemisphere in small patches, weighted by the cosine of incidence, over pi."""
    phi, theta = np.meshgrid(np.radians(AZIMUTH), np.linspace(-np.pi / 2, np.pi / 2, 721), indexing="ij")
    slope, aspect = np.radians(slope_deg), np.radians(aspect_deg)
    normal = np.sin(slope) * np.sin(aspect), np.sin(slope) * np.cos(aspect), np.cos(slope)
    direction = np.cos(theta) * np.sin(phi), np.cos(theta) * np.cos(phi), np.sin(theta)
    incidence = sum(n * d for n, d in zip(normal, direction))
    seen = (theta > np.maximum(np.radians(horizon_deg), 0)[:, None]) & (incidence > 0)
    step = (np.pi / 720) * np.radians(0.5)
    return (np.where(seen, incidence, 0) * np.cos(theta)).sum() * step / np.pi


def test_an_open_plain_sees_all_of_the_sky():
    assert sky_view_of_horizon(AZIMUTH, np.zeros(len(AZIMUTH))) == pytest.approx(1.0)
    assert sky_view_of_horizon(AZIMUTH, np.full(len(AZIMUTH), np.nan)) == pytest.approx(1.0)


@given(height=st.floats(0, 89))
def test_a_basin_sees_the_squared_cosine_of_its_rim(height):
    expected = np.cos(np.radians(height)) ** 2
    assert sky_view_of_horizon(AZIMUTH, np.full(len(AZIMUTH), height)) == pytest.approx(expected, abs=1e-9)


@given(slope=st.floats(0, 89), aspect=st.floats(0, 360))
def test_an_open_slope_sees_half_of_one_plus_cosine(slope, aspect):
    below = np.full(len(AZIMUTH), -20.0)
    expected = (1 + np.cos(np.radians(slope))) / 2
    assert sky_view_of_horizon(AZIMUTH, below, slope, aspect) == pytest.approx(expected, abs=1e-3)


def test_a_wall_along_one_side_takes_half():
    wall = np.where(AZIMUTH < 180, 90.0, 0.0)
    assert sky_view_of_horizon(AZIMUTH, wall) == pytest.approx(0.5, abs=1e-3)


@pytest.mark.parametrize(("slope", "aspect"), [(0, 0), (20, 200), (45, 10), (70, 95)])
def test_it_is_the_integral_of_its_definition(slope, aspect):
    horizon = 15 + 12 * np.sin(np.radians(AZIMUTH)) + 6 * np.cos(np.radians(3 * AZIMUTH))
    exact = by_quadrature(horizon, slope, aspect)
    assert sky_view_of_horizon(AZIMUTH, horizon, slope, aspect) == pytest.approx(exact, abs=4e-3)


def test_a_higher_horizon_never_shows_more_sky():
    rng = np.random.default_rng(0)
    low = rng.uniform(0, 40, len(AZIMUTH))
    assert sky_view_of_horizon(AZIMUTH, low + 5, 25, 130) <= sky_view_of_horizon(AZIMUTH, low, 25, 130)


def test_the_raster_agrees_with_the_horizon_of_single_cells():
    ground = fractal(121, seed=3)
    options = SkyViewOptions(azimuths=64, max_distance_m=1500.0, step_growth=0.02, inclined=False)
    tiles = list(sky_view_raster(ArrayTerrain(ground, 30.0), Window(50, 50, 21, 21), options))
    assert len(tiles) == 1
    window, factor = tiles[0]
    for row, col in ((55, 55), (60, 62), (70, 50)):
        terrain, observer = stand(ground, 30.0, row, col, 0.0)
        profile = horizon_profile(
            terrain, observer, HorizonOptions(max_distance_m=1500.0, azimuth_step_deg=2.0, near_skip_cells=1.0)
        )
        single = sky_view_of_horizon(profile.azimuth_deg, np.maximum(profile.elevation_deg, 0))
        assert factor[row - window.row, col - window.col] == pytest.approx(single, abs=0.01)
        assert sky_view_factor(profile) == pytest.approx(single, abs=1e-6)


def test_tiles_join_without_a_seam_and_voids_stay_void():
    ground = fractal(90, seed=5)
    ground[10:14, 20:25] = np.nan
    terrain, results = ArrayTerrain(ground, 30.0), []
    for tile in (90, 32):
        whole = np.zeros(ground.shape, np.float32)
        options = SkyViewOptions(azimuths=16, max_distance_m=900.0, tile=tile)
        for window, factor in sky_view_raster(terrain, Window(0, 0, 90, 90), options):
            whole[window.row : window.row + window.rows, window.col : window.col + window.cols] = factor
        results.append(whole)
    assert np.allclose(*results, atol=1e-5, equal_nan=True)
    assert np.isnan(results[0][10:14, 20:25]).all()
    assert np.isfinite(np.delete(results[0], slice(9, 16), axis=0)).all()
    known = np.isfinite(results[0])
    assert ((results[0][known] >= 0) & (results[0][known] <= 1)).all()


def test_a_smooth_slope_sees_as_the_closed_form_says():
    row, col = np.mgrid[:101, :101]
    slope = (100 - row) * 30.0 * np.tan(np.radians(30.0))  # falls to the south
    options = SkyViewOptions(azimuths=180, max_distance_m=1200.0)
    (_, factor), *_ = sky_view_raster(ArrayTerrain(slope.astype(np.float32), 30.0), Window(48, 48, 5, 5), options)
    # Downhill the search meets the slope itself, which here ends within the range; the plane bounds the rest.
    assert np.allclose(factor, (1 + np.cos(np.radians(30))) / 2, atol=0.02)


@pytest.mark.parametrize("wrong", [{"azimuths": 2}, {"max_distance_m": 0}, {"tile": 1}])
def test_options_out_of_range_are_refused(wrong):
    with pytest.raises(ValueError):
        SkyViewOptions(**wrong)
