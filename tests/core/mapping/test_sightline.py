from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.base.curvature import apparent_drop_m
from skyline_viewshed.core.base.frame import tabulate_frame
from skyline_viewshed.core.base.terrain import ArrayTerrain, Window, bilinear
from skyline_viewshed.core.mapping import sightline
from skyline_viewshed.core.mapping.march import build_pyramid
from skyline_viewshed.core.mapping.sightline import BEYOND, GROUND, SKY, VOID, SightLines, SightOptions, cast_rays

CELL_M = 30.0


def rolling(seed=1, size=301):
    """Hills of several sizes, 300 m of relief."""
    rng = np.random.default_rng(seed)
    row, col = np.mgrid[:size, :size] / size * 2 * np.pi
    z = np.full((size, size), 1000.0)
    for waves in range(1, 25):
        a, b = rng.normal(size=2) * waves
        z += rng.normal() * 120 / waves * np.cos(a * row + b * col + rng.uniform(0, 6.3))
    return ArrayTerrain(z.astype(np.float32), CELL_M)


def flat(size=201, elevation_m=0.0):
    return ArrayTerrain(np.full((size, size), elevation_m, np.float32), CELL_M)


def marched(terrain, frame, eye_m, azimuth_deg, elevation_deg, end_m, step_m=1.0):
    """Distance of the first crossing by brute force: dense samples of the surface along the ray, then a line."""
    d = np.arange(0.2, end_m, step_m)
    angle = np.radians(azimuth_deg)
    col, row = frame.to_pixel(d * np.sin(angle), d * np.cos(angle))
    ray = eye_m + d * np.tan(np.radians(elevation_deg)) + apparent_drop_m(d)
    gap = bilinear(terrain.elevation_m, row, col) - ray
    hit = np.flatnonzero(gap >= 0)
    if not hit.size:
        return np.nan
    k = hit[0]
    return d[0] if k == 0 else d[k - 1] + step_m * gap[k - 1] / (gap[k - 1] - gap[k])


def test_a_plane_is_met_where_trigonometry_says():
    terrain, frame = flat(), flat().frame(0, 0, 5000)
    angle = np.array([-5.0, -10.0, -45.0, -80.0])
    hits = cast_rays(terrain, frame, SightLines(100.0, np.array([0.0, 90.0, 200.0, 315.0]), angle))
    flat_distance = 100.0 / np.tan(np.radians(-angle))
    # The earth falls away by (1 - k) d^2 / 2R below the tangent plane, so the plane grid is met that much sooner.
    expected = flat_distance + apparent_drop_m(flat_distance) / np.tan(np.radians(-angle))
    assert (hits.state == GROUND).all()
    assert hits.distance_m == pytest.approx(expected, rel=1e-4)
    assert hits.elevation_m == pytest.approx(0.0, abs=0.02)
    assert hits.east_m == pytest.approx(hits.distance_m * np.sin(np.radians([0, 90, 200, 315])), abs=1e-6)


def test_refraction_can_be_switched_off_by_its_coefficient():
    terrain, frame = flat(401), flat(401).frame(0, 0, 6000)
    straight = cast_rays(terrain, frame, SightLines(50.0, 10.0, -0.6), SightOptions(refraction_coefficient=1.0))
    assert float(straight.distance_m) == pytest.approx(50 / np.tan(np.radians(0.6)), rel=1e-6)
    curved = cast_rays(terrain, frame, SightLines(50.0, 10.0, -0.6))
    assert float(curved.distance_m) > float(straight.distance_m)


def test_rays_agree_with_brute_force_on_rolling_ground():
    terrain = rolling()
    frame = terrain.frame(0, 0, 4000)
    rng = np.random.default_rng(4)
    azimuth, elevation = rng.uniform(0, 360, 300), rng.uniform(-20, 6, 300)
    eye = float(terrain.elevation_m[150, 150]) + 15
    hits = cast_rays(terrain, frame, SightLines(eye, azimuth, elevation))
    expected = np.array([marched(terrain, frame, eye, a, e, 6000) for a, e in zip(azimuth, elevation)])
    known = np.isfinite(expected)
    assert 50 < known.sum() < 295
    # Brute force may step over a crest that a ray only just touches.
    apart = np.abs(hits.distance_m[known] - expected[known])
    assert (apart > 1.0).mean() <= 0.01
    assert np.median(apart) < 0.01
    assert (hits.state[~known] != GROUND).mean() > 0.98


@settings(max_examples=30, deadline=None)
@given(st.floats(0, 360), st.floats(-30, 3), st.integers(0, 5))
def test_the_found_point_lies_on_the_surface_and_on_the_ray(azimuth_deg, elevation_deg, seed):
    terrain = rolling(seed, 151)
    frame = terrain.frame(0, 0, 2500)
    eye = float(terrain.elevation_m[75, 75]) + 30
    hit = cast_rays(terrain, frame, SightLines(eye, azimuth_deg, elevation_deg))
    if hit.state == GROUND:
        col, row = frame.to_pixel(hit.east_m, hit.north_m)
        surface = float(bilinear(terrain.elevation_m, row, col))
        assert float(hit.elevation_m) == pytest.approx(surface, abs=0.05)
        d = float(hit.distance_m)
        ray = eye + d * np.tan(np.radians(elevation_deg)) + apparent_drop_m(d)
        assert float(hit.elevation_m) == pytest.approx(ray, abs=1e-6)


def test_steeper_rays_land_nearer_in_one_direction():
    terrain = rolling(3)
    frame = terrain.frame(0, 0, 4000)
    elevation = np.linspace(-40, 5, 400)
    hits = cast_rays(
        terrain, frame, SightLines(float(terrain.elevation_m[150, 150]) + 20, np.full(400, 77.0), elevation)
    )
    distance = np.where(hits.on_ground, hits.distance_m, np.inf)
    assert (np.diff(distance[np.isfinite(distance)]) > 0).all()
    assert hits.on_ground[0] and not hits.on_ground[-1]


def test_a_wall_of_one_cell_stops_the_ray_at_its_face():
    z = np.zeros((101, 101), np.float32)
    z[30] = 200.0  # 20 cells north of the eye
    terrain = ArrayTerrain(z, CELL_M)
    frame = terrain.frame(0, 0, 1600)
    hits = cast_rays(terrain, frame, SightLines(10.0, np.zeros(2), np.array([8.0, 20.0])))
    assert hits.state.tolist() == [GROUND, SKY]
    rise = 10 + hits.distance_m[0] * np.tan(np.radians(8.0))
    assert hits.distance_m[0] == pytest.approx(19 * CELL_M + CELL_M * rise / 200.0, rel=1e-3)


def test_what_lies_nearer_than_the_minimum_distance_stops_nothing():
    z = np.zeros((101, 101), np.float32)
    z[45:48] = 50.0
    terrain = ArrayTerrain(z, CELL_M)
    frame = terrain.frame(0, 0, 1600)
    near = cast_rays(terrain, frame, SightLines(10.0, 0.0, -1.0))
    far = cast_rays(terrain, frame, SightLines(10.0, 0.0, -1.0), SightOptions(min_distance_m=300.0))
    assert near.distance_m < 120 and far.distance_m == pytest.approx(10 / np.tan(np.radians(1)), rel=0.01)


def test_an_eye_inside_the_hill_looks_out_of_it():
    z = np.zeros((101, 101), np.float32)
    z[48:53, 48:53] = 40.0
    terrain = ArrayTerrain(z, CELL_M)
    hit = cast_rays(terrain, terrain.frame(0, 0, 1600), SightLines(30.0, 0.0, -3.0))
    assert hit.state == GROUND and hit.distance_m > 300 and hit.elevation_m == pytest.approx(0, abs=0.1)


def test_sky_void_and_ground_beyond_the_dem_are_told_apart():
    z = np.zeros((201, 201), np.float32)
    z[40:60, 80:120] = np.nan
    terrain = ArrayTerrain(z, CELL_M)
    frame = terrain.frame(0, 0, 3100)
    azimuth = np.array([0.0, 0.0, 180.0, 180.0])
    elevation = np.array([10.0, -2.0, -0.5, -5.0])
    hits = cast_rays(terrain, frame, SightLines(60.0, azimuth, elevation))
    assert hits.state.tolist() == [SKY, VOID, BEYOND, GROUND]
    assert np.isnan(hits.east_m[:3]).all() and np.isfinite(hits.east_m[3])


def test_a_ray_high_above_a_void_is_not_held_up_by_it():
    z = np.zeros((201, 201), np.float32)
    z[40:60] = np.nan
    z[:30] = 500.0
    terrain = ArrayTerrain(z, CELL_M)
    hit = cast_rays(terrain, terrain.frame(0, 0, 3100), SightLines(60.0, 0.0, 5.0))
    assert hit.state == GROUND and hit.elevation_m > 200


def test_nothing_beyond_the_given_end_is_asked():
    terrain = flat()
    hits = cast_rays(
        terrain, terrain.frame(0, 0, 3100), SightLines(100.0, np.zeros(2), np.full(2, -10.0), end_m=[500.0, 600.0])
    )
    assert hits.state.tolist()[1] == GROUND and hits.state[0] != GROUND


def test_windows_of_any_size_give_the_same_answer(monkeypatch):
    terrain = rolling(8)
    frame = terrain.frame(0, 0, 4000)
    azimuth, elevation = np.linspace(0, 359, 200), np.linspace(-12, 3, 200)
    eye = float(terrain.elevation_m[150, 150]) + 15
    whole = cast_rays(terrain, frame, SightLines(eye, azimuth, elevation))
    monkeypatch.setattr(sightline, "MAX_WINDOW_CELLS", 3000)
    monkeypatch.setattr(sightline, "BATCH_RAYS", 37)
    parts = cast_rays(terrain, frame, SightLines(eye, azimuth, elevation))
    assert (whole.state == parts.state).all()
    assert whole.distance_m == pytest.approx(parts.distance_m, abs=0.05, nan_ok=True)


def test_a_bent_frame_follows_the_bent_track():
    terrain = rolling(5)

    def transform(east, north):
        # Scale grows to the east and columns lean: what a projected CRS does, exaggerated.
        return 150 + (east + 2e-6 * east**2) / CELL_M, 150 - (north + 3e-6 * east * north) / CELL_M

    frame = tabulate_frame(0, 0, transform, 4000.0)
    assert frame.remainder_px is not None
    rng = np.random.default_rng(2)
    azimuth, elevation = rng.uniform(0, 360, 60), rng.uniform(-15, 2, 60)
    eye = float(terrain.elevation_m[150, 150]) + 15
    hits = cast_rays(terrain, frame, SightLines(eye, azimuth, elevation))
    expected = np.array([marched(terrain, frame, eye, a, e, 4000) for a, e in zip(azimuth, elevation)])
    both = np.isfinite(expected) & hits.on_ground
    assert both.sum() > 20
    assert np.median(np.abs(hits.distance_m[both] - expected[both])) < 0.05


@pytest.mark.parametrize("shape", [(2, 2), (3, 5), (64, 65), (2, 40)])
def test_every_bound_is_the_maximum_of_its_block(shape):
    z = np.random.default_rng(0).uniform(0, 100, shape).astype(np.float32)
    pyramid = build_pyramid(z)
    for level, bound in enumerate(pyramid.bound_m):
        side = 2**level
        for i in range(bound.shape[0]):
            for j in range(bound.shape[1]):
                block = z[i * side : (i + 1) * side + 1, j * side : (j + 1) * side + 1]
                assert bound[i, j] == block.max()


def test_a_dem_of_voids_alone_is_no_sky_and_no_crash():
    terrain = ArrayTerrain(np.full((50, 50), np.nan, np.float32), CELL_M)
    hits = cast_rays(terrain, terrain.frame(0, 0, 700), SightLines(100.0, np.zeros(2), np.array([-10.0, 10.0])))
    assert (hits.state != GROUND).all()


def test_options_refuse_an_empty_range():
    with pytest.raises(ValueError, match="min < max"):
        SightOptions(min_distance_m=100, max_distance_m=100)


def test_reading_stays_within_the_raster():
    class Strict(ArrayTerrain):
        def read(self, window):
            assert window == Window(window.row, window.col, window.rows, window.cols).clipped(self.shape)
            return super().read(window)

    terrain = Strict(rolling(2).elevation_m, CELL_M)
    corner = terrain.position_of(3, 3)
    frame = terrain.frame(*corner, 20_000)
    hits = cast_rays(terrain, frame, SightLines(1500.0, np.linspace(0, 350, 36), np.full(36, -8.0)))
    assert hits.on_ground.any() and not hits.on_ground.all()
