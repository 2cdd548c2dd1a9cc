import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from reference.landscapes import fractal, stand, summits, write_summits
from reference.sight_lines import horizon_by_samples
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.errors import Cancelled, NoElevationAtObserverError, ObserverOutsideDemError
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer, Terrain, Window
from skyline_viewshed.core.horizon.horizon import HorizonOptions, horizon_profile

EARTH_M, REFRACTION = 6_371_000.0, 0.13


def cast(elevation, cell_m, row, col, eye_height_m=1.7, eye_elevation_m=None, **options):
    terrain, observer = stand(elevation, cell_m, row, col, eye_height_m, eye_elevation_m)
    return horizon_profile(terrain, observer, HorizonOptions(**options))


def test_a_flat_earth_dips_by_the_square_root_of_twice_height_over_radius():
    profile = cast(np.zeros((801, 801)), 100.0, 400, 400, eye_height_m=50.0, max_distance_m=39_000.0)
    radius = EARTH_M / (1 - REFRACTION)
    assert np.allclose(profile.elevation_deg, -np.degrees(np.sqrt(2 * 50 / radius)), atol=1e-4)
    assert np.allclose(profile.distance_m, np.sqrt(2 * 50 * radius), rtol=0.01)
    assert not profile.clipped.any()
    assert not profile.void.any()


def test_a_far_summit_appears_at_the_range_of_both_heights():
    """sqrt(2 R h1) + sqrt(2 R h2): nearer than that the summit rises above the plain's horizon, farther it does not."""
    radius = EARTH_M / (1 - REFRACTION)
    reach = np.sqrt(2 * radius * 30) + np.sqrt(2 * radius * 120)
    for share, above in ((0.97, True), (1.03, False)):
        cells = int(reach * share / 200)
        ground = np.zeros((5, cells + 40), np.float32)
        ground[:, 10 + cells] = 120.0
        profile = cast(ground, 200.0, 2, 10, eye_height_m=30.0, azimuth_step_deg=90.0)
        assert (profile.elevation_deg[1] > -np.degrees(np.sqrt(2 * 30 / radius)) + 1e-6) == above


def test_a_cone_is_seen_at_its_apex():
    row, col = np.mgrid[:201, :201]
    cone = 1000.0 - np.hypot(row - 40, col - 100) * 5
    profile = cast(cone, 10.0, 150, 100, eye_elevation_m=500.0, curvature=False)
    assert profile.elevation_deg[0] == pytest.approx(np.degrees(np.arctan(500 / 1100)), abs=1e-9)
    assert profile.distance_m[0] == pytest.approx(1100, abs=1e-6)
    assert np.nanargmax(profile.elevation_deg) == 0


@pytest.mark.parametrize("azimuth", range(0, 360, 45))
def test_an_infinite_ridge_sinks_with_the_secant_of_the_bearing(azimuth):
    """A wall of height h at distance d seen under an angle a off its normal has tangent h cos(a) / d."""
    side, cell = 401, 10.0
    row, col = np.mgrid[:side, :side] - 200.0
    facing = np.radians(azimuth)
    # Distance towards the azimuth; the crest line passes through cells only for multiples of 45 degrees.
    ahead = (col * np.sin(facing) - row * np.cos(facing)) / max(abs(np.sin(facing)), abs(np.cos(facing)))
    ridge = np.maximum(200.0 - 5.0 * np.abs(ahead - 60), 0.0)
    profile = cast(ridge, cell, 200, 200, eye_elevation_m=0.0, curvature=False, azimuth_step_deg=1.0)
    distance = 60 * cell * max(abs(np.sin(facing)), abs(np.cos(facing)))
    for off in (-30, 0, 30):
        seen = profile.elevation_deg[(azimuth + off) % 360]
        assert seen == pytest.approx(
            np.degrees(np.arctan(200 * np.cos(np.radians(off)) / distance)), abs=0.35
        )  # on the diagonal the crest sags by 2.5 m between cells


def test_a_wall_of_one_cell_is_not_missed():
    ground = np.zeros((301, 301), np.float32)
    ground[20, 150] = 100.0
    profile = cast(ground, 10.0, 150, 150, eye_elevation_m=0.0, curvature=False)
    assert profile.elevation_deg[0] == pytest.approx(np.degrees(np.arctan(100 / 1300)), abs=1e-9)


def test_from_the_floor_of_a_pit_the_rim_is_the_horizon():
    row, col = np.mgrid[:101, :101]
    pit = np.where(np.hypot(row - 50, col - 50) > 20, 100.0, 0.0)
    profile = cast(pit, 10.0, 50, 50, eye_elevation_m=0.0, curvature=False)
    assert profile.elevation_deg.min() > np.degrees(np.arctan(100 / 230))
    assert profile.elevation_deg.max() < np.degrees(np.arctan(100 / 190))


@pytest.mark.parametrize(("row", "col"), [(100, 100), (100.3, 99.6), (3.0, 180.5), (0, 0)])
def test_it_agrees_with_dense_sampling_of_every_ray(row, col):
    ground = fractal(201, seed=5)
    profile = cast(ground, 30.0, row, col, azimuth_step_deg=7.5)
    found, expected = [], []
    # The outer half cell is known to the search and not to the reference.
    inner = profile.distance_m < profile.reach_m - 45
    for azimuth, elevation in zip(profile.azimuth_deg[inner], profile.elevation_deg[inner]):
        ray = ground, 30.0, row, col, profile.eye_elevation_m, azimuth
        dense = max(horizon_by_samples(*ray, 45.0, 300.0, 0.05), horizon_by_samples(*ray, 300.0, 9000.0, 0.5))
        if not np.isnan(dense):
            found.append(elevation)
            expected.append(dense)
    assert len(found) >= 5
    error = np.subtract(found, expected)
    assert np.sqrt((error**2).mean()) < 0.01
    assert error.min() > -0.01  # the search may find a crest between samples, but may not miss one


def test_the_result_does_not_depend_on_how_the_terrain_is_read():
    ground = fractal(700, seed=6)
    ground[300:320, 100:130] = np.nan
    whole = cast(ground, 30.0, 350.2, 340.7)
    tiles = cast(ground, 30.0, 350.2, 340.7, memory_mb=0.01)
    for name in ("elevation_deg", "distance_m", "clipped", "void", "reach_m"):
        assert np.array_equal(getattr(whole, name), getattr(tiles, name), equal_nan=True), name


@settings(max_examples=15, deadline=None)
@given(seed=st.integers(0, 1000), near=st.floats(1000, 3000), far=st.floats(3000, 9000))
def test_more_range_never_lowers_the_horizon(seed, near, far):
    ground = fractal(257, seed)
    low, high = (
        cast(ground, 30.0, 128.4, 127.7, max_distance_m=reach, azimuth_step_deg=3.0).elevation_deg
        for reach in (near, far)
    )
    # The rays are cut into intervals differently. In 3 of 1500 random cases the longer range was lower by more than
    # 0.002 degrees, at worst by 0.034.
    assert (high >= low - 0.05).all()
    assert np.median(low - high) <= 1e-9


@settings(max_examples=15, deadline=None)
@given(seed=st.integers(0, 1000), lift=st.floats(0, 300))
def test_a_higher_eye_sees_everything_lower(seed, lift):
    ground = fractal(129, seed)
    low = cast(ground, 30.0, 64, 64, 2.0, azimuth_step_deg=3.0).elevation_deg
    high = cast(ground, 30.0, 64, 64, 2.0 + lift, azimuth_step_deg=3.0).elevation_deg
    assert (high <= low + 2e-3).all()


@pytest.mark.parametrize("turns", [1, 2, 3])
def test_turned_terrain_turns_the_horizon(turns):
    ground = fractal(151, seed=8)
    straight = cast(ground, 30.0, 75, 75).elevation_deg
    turned = cast(np.rot90(ground, -turns), 30.0, 75, 75).elevation_deg
    assert np.allclose(np.roll(straight, 900 * turns), turned, atol=2e-3)


def test_ground_beyond_the_edge_that_could_be_higher_flags_the_horizon_as_clipped():
    ground = np.zeros((401, 401), np.float32)
    ground[100:110] = 100.0
    profile = cast(ground, 30.0, 200, 200, azimuth_step_deg=45.0)
    assert not profile.clipped[0]  # a wall as high as anything known stands before the edge
    assert profile.clipped[4]
    assert profile.reach_m[0] == pytest.approx(200.5 * 30)
    assert not profile.void.any()
    higher = cast(ground, 30.0, 200, 200, azimuth_step_deg=45.0, summit_m=8000.0)
    assert higher.clipped.all()


def test_a_void_that_could_hide_a_higher_horizon_is_flagged_and_one_behind_a_wall_is_not():
    ground = np.zeros((401, 401), np.float32)
    ground[100:110] = 100.0
    ground[60:80] = np.nan
    ground[300:310] = np.nan
    profile = cast(ground, 30.0, 200, 200, azimuth_step_deg=45.0)
    assert list(profile.void) == [False, False, False, True, True, True, False, False]
    assert np.isfinite(profile.elevation_deg).all()


def test_voids_up_to_the_edge_are_the_end_of_the_dem():
    ground = np.zeros((401, 401), np.float32)
    ground[300:] = np.nan
    ground[0, 0] = 50.0
    profile = cast(ground, 30.0, 200, 200, azimuth_step_deg=90.0)
    assert not profile.void[2]
    assert profile.clipped[2]
    assert 100 * 30 <= profile.reach_m[2] < 120 * 30


def test_where_nothing_is_known_the_horizon_is_nan_and_not_level():
    ground = np.full((101, 101), np.nan, np.float32)
    ground[45:56, :] = 10.0
    profile = cast(ground, 10.0, 50, 50, azimuth_step_deg=1.0, near_skip_cells=8.0)
    assert np.isnan(profile.elevation_deg[[0, 180]]).all()
    assert np.isfinite(profile.elevation_deg[[90, 270]]).all()
    assert profile.clipped[[0, 180]].all()
    assert np.array_equal(np.isnan(profile.elevation_deg), np.isnan(profile.distance_m))


def test_a_dem_of_one_cell_knows_no_horizon():
    profile = cast(np.array([[100.0]]), 30.0, 0, 0, azimuth_step_deg=10.0)
    assert np.isnan(profile.elevation_deg).all()
    assert profile.clipped.all()


@pytest.mark.parametrize(("row", "col"), [(0, 0), (100, 50), (-0.5, 20), (50, 100.5)])
def test_the_observer_may_stand_on_the_edge(row, col):
    profile = cast(np.zeros((101, 101)), 10.0, row, col, azimuth_step_deg=15.0)
    assert np.isfinite(profile.elevation_deg).sum() >= 7
    assert profile.clipped.all()


def test_the_observer_may_not_stand_outside_or_in_a_void():
    with pytest.raises(ObserverOutsideDemError):
        cast(np.zeros((50, 50)), 10.0, 60, 20)
    hole = np.zeros((50, 50), np.float32)
    hole[10:20, 10:20] = np.nan
    with pytest.raises(NoElevationAtObserverError):
        cast(hole, 10.0, 15, 15)
    assert np.isfinite(cast(hole, 10.0, 15, 15, eye_elevation_m=20.0).elevation_deg).any()


@pytest.mark.parametrize("dtype", ["int16", "float64", "uint8"])
def test_the_type_of_the_elevations_does_not_matter(dtype):
    ground = np.rint(fractal(101, seed=9, relief_m=200.0))
    expected = cast(ground, 30.0, 50, 50).elevation_deg
    assert np.array_equal(cast(ground.astype(dtype), 30.0, 50, 50).elevation_deg, expected)


def test_cancelling_stops_it():
    class Stop:
        def report(self, fraction):
            pass

        def cancelled(self):
            return True

    terrain, observer = stand(fractal(101, seed=1), 30.0, 50, 50)
    with pytest.raises(Cancelled):
        horizon_profile(terrain, observer, progress=Stop())


@pytest.mark.parametrize(
    "wrong", [{"azimuth_step_deg": 0}, {"max_distance_m": -1}, {"refraction_coefficient": 1}, {"near_skip_cells": 0}]
)
def test_options_out_of_range_are_refused(wrong):
    with pytest.raises(ValueError):
        HorizonOptions(**wrong)


class Endless(Terrain):
    """A terrain of 100,000 x 100,000 cells that exists only where it is read; counts what is read at once."""

    shape = (100_000, 100_000)

    def __init__(self):
        self.flat = ArrayTerrain(np.zeros((1, 1), np.float32), 1.0)
        self.most = self.total = 0

    def read(self, window):
        self.most, self.total = max(self.most, window.rows * window.cols), self.total + window.rows * window.cols
        row = np.arange(window.row, window.row + window.rows, dtype=np.float32)[:, None]
        col = np.arange(window.col, window.col + window.cols, dtype=np.float32)
        return 50 * np.sin(row / 300) * np.cos(col / 400) + np.float32(200)

    def frame(self, longitude_deg, latitude_deg, radius_m):
        from skyline_viewshed.core.base.frame import tabulate_frame

        return tabulate_frame(0, 0, lambda east, north: (5e4 + east / 10, 5e4 - north / 10), radius_m, size=3)


def test_a_virtual_raster_of_ten_gigapixels_is_read_in_small_pieces_and_only_in_range():
    terrain = Endless()
    options = HorizonOptions(max_distance_m=20_000.0, azimuth_step_deg=1.0, memory_mb=10.0)
    profile = horizon_profile(terrain, Observer(0.0, 0.0, 100.0), options)
    assert np.isfinite(profile.elevation_deg).all()
    assert terrain.most <= 512 * 4100
    assert terrain.total < 2 * 4100**2


def test_terrain_that_fits_into_memory_is_read_once():
    terrain = Endless()
    horizon_profile(terrain, Observer(0.0, 0.0, 100.0), HorizonOptions(max_distance_m=10_000.0, memory_mb=20.0))
    assert terrain.total < 1.02 * 2010**2


CENTRE = (-149.5, 61.1)


@pytest.fixture(scope="module")
def many_crs(tmp_path_factory):
    """One mountain group in many coordinate systems, and the horizon of each."""
    pytest.importorskip("osgeo.gdal")
    from skyline_viewshed.core.io.raster import open_dem

    folder = tmp_path_factory.mktemp("crs")
    profiles = {}
    for name, crs, cell, south_up in (
        ("utm", "EPSG:32606", (50, 50), False),
        ("south up", "EPSG:32606", (50, 50), True),
        ("polar stereographic", "EPSG:3413", (50, 50), False),
        ("web mercator, not square", "EPSG:3857", (90, 120), False),
        ("geographic", "EPSG:4326", (0.0009, 0.00045), False),
    ):
        dem = open_dem(write_summits(folder / f"{name}.tif", crs, cell, CENTRE, south_up=south_up))
        observer = Observer(*CENTRE, eye_elevation_m=float(summits(*CENTRE, CENTRE)) + 20)
        profiles[name] = horizon_profile(dem, observer, HorizonOptions(max_distance_m=12_000.0, azimuth_step_deg=1.0))
    return profiles


@pytest.mark.parametrize("name", ["south up", "polar stereographic", "web mercator, not square", "geographic"])
def test_one_mountain_has_one_horizon_in_any_crs(many_crs, name):
    assert np.abs(many_crs[name].elevation_deg - many_crs["utm"].elevation_deg).max() < 0.05
    far = many_crs["utm"].distance_m > 2000
    assert np.median(np.abs(many_crs[name].distance_m / many_crs["utm"].distance_m - 1)[far]) < 0.01


def test_the_highest_summit_stands_at_its_true_bearing_and_angle(many_crs):
    for profile in many_crs.values():
        north = np.abs(difference(profile.azimuth_deg, 0)) < 5
        assert np.degrees(np.arctan((1830 - 20) / 9000)) == pytest.approx(profile.elevation_deg[north].max(), abs=0.3)


@pytest.mark.parametrize(
    ("crs", "cell", "centre"),
    [
        ("EPSG:4326", (0.004, 0.0005), (15.0, 84.0)),
        ("EPSG:4326", (0.0006, 0.0005), (179.98, 51.9)),
        ("EPSG:3031", (60, 60), (-68.0, -78.0)),
    ],
)
def test_close_to_a_pole_and_across_the_antimeridian(tmp_path, crs, cell, centre):
    pytest.importorskip("osgeo.gdal")
    from skyline_viewshed.core.io.raster import open_dem

    dem = open_dem(write_shifted(tmp_path / "dem.tif", crs, cell, centre))
    eye = float(summits(*centre, centre)) + 20
    profile = horizon_profile(
        dem, Observer(*centre, eye_elevation_m=eye), HorizonOptions(max_distance_m=11_000.0, azimuth_step_deg=1.0)
    )
    north = np.abs(difference(profile.azimuth_deg, 0)) < 5
    assert np.degrees(np.arctan((1830 - 20) / 9000)) == pytest.approx(profile.elevation_deg[north].max(), abs=0.3)
    assert np.isfinite(profile.elevation_deg).all()
    assert profile.distance_m.max() <= 11_000.0 + 1e-6


def write_shifted(path, crs, cell, centre):
    """`write_summits`, with longitudes beyond 180 degrees kept growing where the group crosses the antimeridian."""
    if crs != "EPSG:4326" or centre[0] < 179:
        return write_summits(path, crs, cell, centre)
    from osgeo import gdal, osr

    reference = osr.SpatialReference()
    reference.SetFromUserInput(crs)
    left, top, cols, rows = centre[0] - 0.25, centre[1] + 0.15, int(0.5 / cell[0]), int(0.3 / cell[1])
    longitude = left + (np.arange(cols) + 0.5) * cell[0]
    latitude = top - (np.arange(rows) + 0.5) * cell[1]
    raster = gdal.GetDriverByName("GTiff").Create(str(path), cols, rows, 1, gdal.GDT_Float32)
    raster.SetGeoTransform((left, cell[0], 0, top, 0, -cell[1]))
    raster.SetProjection(reference.ExportToWkt())
    raster.GetRasterBand(1).WriteArray(summits(longitude[None, :], latitude[:, None], centre).astype(np.float32))
    return str(path)


ZOO = {
    "vestfold_epsg3031_32m.tif": None,
    "AST_L1A_00303182012144228_Z.tif": None,
    "N43E007.hgt": (7.3, 43.85),
    "N43E006_3857.tiff": None,
    "S33W071.tif": (-70.01, -32.65),
    "dem_SouthGlacier.tif": None,
    "LisbonElevation.tif": None,
}


@pytest.mark.data
@pytest.mark.parametrize("name", ZOO)
def test_every_elevation_model_of_the_zoo_has_a_horizon(shared_data, name):
    pytest.importorskip("osgeo.gdal")
    from skyline_viewshed.core.io.raster import open_dem

    dem = open_dem(str(shared_data / "dem" / name))
    position = ZOO[name] or dem.position_of(*first_known(dem))
    profile = horizon_profile(
        dem, Observer(*map(float, position)), HorizonOptions(max_distance_m=20_000.0, azimuth_step_deg=1.0)
    )
    known = np.isfinite(profile.elevation_deg)
    assert known.mean() > 0.5
    assert (np.abs(profile.elevation_deg[known]) < 60).all()
    assert (profile.distance_m[known] <= profile.reach_m[known] + 1e-6).all()
    assert (profile.clipped | profile.void | known).all()


def first_known(dem):
    """(col, row) of a known cell near the raster's middle."""
    rows, cols = dem.shape
    for share in (0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8):
        window = Window(int(rows * share), 0, 1, cols)
        known = np.flatnonzero(np.isfinite(dem.read(window)[0]))
        if len(known):
            return known[len(known) // 2], window.row
    raise AssertionError("no known cell")
