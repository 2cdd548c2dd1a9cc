import numpy as np
import pytest
from reference.landscapes import fractal, stand, summits, write_summits
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.errors import NoElevationAtObserverError, ObserverOutsideDemError
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.paper.horizon import PaperHorizonOptions, paper_horizon


def by_the_letter(ground, cell_m, row, col, azimuth_deg, max_distance_m=15_000.0):
    """Equations 2 to 4 as a loop."""
    eye, best, step = ground[row, col] + 1.7, -np.inf, 1
    while step * cell_m <= max_distance_m:
        r = int(np.floor(row - step * np.cos(np.radians(azimuth_deg)) + 0.5))
        c = int(np.floor(col + step * np.sin(np.radians(azimuth_deg)) + 0.5))
        if not (0 <= r < ground.shape[0] and 0 <= c < ground.shape[1]):
            break
        best = max(best, (ground[r, c] - eye) / (step * cell_m))
        step += 1
    return np.degrees(np.arctan(best))


def test_it_is_the_papers_loop():
    ground = fractal(151, seed=2).astype(float)
    profile = paper_horizon(*stand(ground, 30.0, 70, 80))
    assert len(profile.azimuth_deg) == 3600
    for index in range(7, 3600, 97):
        assert profile.elevation_deg[index] == pytest.approx(
            by_the_letter(ground, 30.0, 70, 80, profile.azimuth_deg[index]), abs=1e-4
        )


def test_the_earth_is_a_plane_and_ends_at_fifteen_kilometres():
    ground = np.zeros((801, 801), np.float32)
    ground[:60] = 500.0
    profile = paper_horizon(*stand(ground, 50.0, 400, 400))
    assert profile.elevation_deg[0] == pytest.approx(np.degrees(np.arctan(-1.7 / 15_000)), abs=1e-6)
    far = paper_horizon(*stand(ground, 50.0, 400, 400), PaperHorizonOptions(max_distance_m=18_000.0))
    assert far.elevation_deg[0] == pytest.approx(np.degrees(np.arctan(498.3 / (341 * 50))), abs=2e-3)


def test_it_stands_on_the_nearest_cell_whatever_the_eye_is_said_to_be():
    ground = fractal(61, seed=3)
    low = paper_horizon(*stand(ground, 30.0, 30, 30))
    other = paper_horizon(*stand(ground, 30.0, 30.3, 29.8, 50.0, 9999.0))
    assert np.array_equal(low.elevation_deg, other.elevation_deg)


def test_voids_are_no_terrain_and_are_flagged():
    ground = np.zeros((101, 101), np.float32)
    ground[20:30] = np.nan
    profile = paper_horizon(*stand(ground, 30.0, 50, 50))
    assert profile.void[0]
    assert not profile.void[1800]
    assert np.isfinite(profile.elevation_deg).all()
    assert profile.clipped.all()
    with pytest.raises(NoElevationAtObserverError):
        paper_horizon(*stand(ground, 30.0, 25, 50))
    with pytest.raises(ObserverOutsideDemError):
        paper_horizon(*stand(ground, 30.0, 250, 50))


@pytest.mark.parametrize("crs", ["EPSG:32606", "EPSG:3413"])
def test_azimuths_are_true_ones_although_its_rays_follow_the_grid(tmp_path, crs):
    pytest.importorskip("osgeo.gdal")
    from skyline_viewshed.core.io.raster import open_dem

    centre = (-149.5, 61.1)
    dem = open_dem(write_summits(tmp_path / "dem.tif", crs, (60, 60), centre))
    profile = paper_horizon(dem, Observer(*centre), PaperHorizonOptions(max_distance_m=11_000.0))
    north = np.abs(difference(profile.azimuth_deg, 0)) < 5
    ahead = np.arange(100.0, 11_000.0, 20.0)
    rise = summits(centre[0], centre[1] + ahead / 111_320, centre) - float(summits(*centre, centre)) - 1.7
    expected = np.degrees(np.arctan((rise / ahead).max()))
    assert profile.elevation_deg[north].max() == pytest.approx(expected, abs=0.4)


def test_options_out_of_range_are_refused():
    with pytest.raises(ValueError):
        PaperHorizonOptions(azimuth_step_deg=0)
