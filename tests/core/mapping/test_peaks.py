from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.terrain import ArrayTerrain
from skyline_viewshed.core.mapping.peaks import find_summits, snap_to_summit, summits_around


def cones(shape, tops, slope=1.0):
    """Highest of several cones (row, col, height)."""
    row, col = np.mgrid[: shape[0], : shape[1]].astype(float)
    return np.max([h - slope * np.hypot(row - r, col - c) for r, c, h in tops], axis=0)


def flooded(z, row, col):
    """Prominence by definition: the highest water level at which no higher ground is joined to the summit."""
    from scipy import ndimage

    top = z[row, col]
    for level in np.unique(z[z <= top])[::-1]:
        label, _ = ndimage.label(z >= level, structure=np.ones((3, 3)))
        if (z[label == label[row, col]] > top).any():
            return top - level
    return top - z[np.isfinite(z)].min()


def test_two_cones_have_their_saddle_between_them():
    z = cones((61, 101), [(30, 20, 100.0), (30, 80, 80.0)])
    summits = find_summits(z, 1.0)
    assert list(zip(summits.row, summits.col)) == [(30, 20), (30, 80)]
    # Both slopes meet at 100 - d = 80 - (60 - d): d = 40, height 60.
    assert summits.prominence_m[1] == pytest.approx(20.0, abs=1.0)
    assert summits.prominence_m[0] == pytest.approx(100 - z.min())
    assert find_summits(z, 30.0).row.size == 1


@pytest.mark.parametrize("seed", range(4))
def test_prominence_equals_its_definition(seed):
    rng = np.random.default_rng(seed)
    z = np.rint(cones((40, 50), [(*rng.uniform(5, 35, 2), h) for h in rng.uniform(20, 60, 12)]) * 3)
    z += rng.integers(0, 4, z.shape)
    summits = find_summits(z, 2.0)
    assert summits.row.size >= 3
    highest = np.argmax(summits.elevation_m)
    for k in range(summits.row.size):
        if k != highest and summits.elevation_m[k] < z.max():
            assert summits.prominence_m[k] == flooded(z, summits.row[k], summits.col[k])


def test_a_plateau_is_one_summit_and_voids_are_none():
    z = np.zeros((20, 20))
    z[5:8, 5:9] = 10.0
    z[12:, 12:] = np.nan
    summits = find_summits(z, 5.0)
    assert summits.row.size == 1 and 5 <= summits.row[0] < 8
    assert find_summits(np.full((5, 5), np.nan), 1.0).row.size == 0


def test_a_named_summit_is_set_on_the_top_of_like_height():
    z = cones((61, 101), [(30, 30, 900.0), (30, 42, 860.0)], 8.0).astype(np.float32)
    terrain = ArrayTerrain(z, 30.0)
    frame = terrain.frame(*terrain.position_of(38, 30), 3000)  # between both, nearer to the lower one
    high = snap_to_summit(terrain, frame, 0.0, 0.0, 905.0)
    low = snap_to_summit(terrain, frame, 0.0, 0.0, 862.0)
    assert high == pytest.approx((-240.0, 0.0, 900.0), abs=1e-3)
    assert low == pytest.approx((120.0, 0.0, 860.0), abs=1e-3)


def test_without_a_height_the_highest_cell_near_by_is_taken():
    z = cones((61, 61), [(30, 33, 500.0)], 8.0).astype(np.float32)
    terrain = ArrayTerrain(z, 30.0)
    frame = terrain.frame(0, 0, 900)
    assert snap_to_summit(terrain, frame, 0.0, 0.0) == pytest.approx((90.0, 0.0, 500.0), abs=1e-3)
    assert snap_to_summit(terrain, frame, 0.0, 0.0, radius_m=60.0)[0] < 30.0 + 1e-6


def test_a_summit_off_the_dem_or_in_a_void_stays_where_it_was_published():
    terrain = ArrayTerrain(np.full((21, 21), np.nan, np.float32), 30.0)
    frame = terrain.frame(0, 0, 900)
    east, north, z = snap_to_summit(terrain, frame, 5.0, 7.0, 100.0)
    assert (east, north) == (5.0, 7.0) and np.isnan(z)
    assert np.isnan(snap_to_summit(terrain, frame, 1e5, 0.0)[2])


def test_the_summits_of_the_khumbu_are_found(shared_data):
    from skyline_viewshed.core.base.terrain import Window
    from skyline_viewshed.core.io.raster import open_dem

    dem = open_dem(shared_data / "khumbu" / "dem" / "khumbu.tif")
    summits = find_summits(dem.read(Window(0, 0, *dem.shape)), 300.0)
    longitude, latitude = dem.position_of(summits.col, summits.row)
    for name, lat, lon, height in (
        ("Everest", 27.9881, 86.9250, 8849),
        ("Ama Dablam", 27.8614, 86.8613, 6812),
        ("Kangtega", 27.7950, 86.8183, 6782),
    ):
        away = np.hypot((longitude - lon) * 98_500, (latitude - lat) * 110_900)
        assert away.min() < 600, name
        assert abs(summits.elevation_m[away.argmin()] - height) < 60, name
    assert summits.elevation_m[0] == pytest.approx(8849, abs=30)


def test_around_an_eye_summits_come_in_local_metres_whatever_the_window():
    z = cones((121, 121), [(60, 90, 900.0), (20, 60, 700.0)], 8.0).astype(np.float32)
    terrain = ArrayTerrain(z, 30.0)
    frame = terrain.frame(0, 0, 2000)
    whole = summits_around(terrain, frame, 1700.0, 50.0)
    assert [summit[:2] for summit in whole] == [pytest.approx((900, 0), abs=1e-3), pytest.approx((0, 1200), abs=1e-3)]
    assert [summit[2] for summit in whole] == [900, 700]
    blocks = summits_around(terrain, frame, 1700.0, 50.0, most_cells=2000)
    assert [summit[:3] for summit in blocks] == [pytest.approx(summit[:3]) for summit in whole]
    assert [s[2] for s in summits_around(terrain, frame, 1000.0, 50.0)] == [900]
    assert summits_around(terrain, terrain.frame(1.0, 1.0, 2000), 1000.0, 50.0) == []
