"""The piece of a DEM under a figure: what must be on it is, at its place, and strips and blocks leave no seam."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.base.terrain import ArrayTerrain, Window
from skyline_viewshed.core.figures import ground as figures_ground
from skyline_viewshed.core.figures.ground import (
    GAP_PX,
    SMALLEST_M,
    GroundMapOptions,
    SeenGround,
    ground_map,
    three_panels,
)
from skyline_viewshed.core.figures.map import MapData, MapObserver


def sloping(rows=90, cols=120, cell_m=30.0):
    row, col = np.indices((rows, cols))
    return ArrayTerrain((1000 + 10.0 * row + col).astype(np.float32), cell_m)


def frame_of(terrain, col_px=20.0, row_px=70.0):
    return terrain.frame(*terrain.position_of(col_px, row_px), 10_000.0)


def patch(window, cells, value=1):
    values = np.zeros((window.rows, window.cols), np.uint8)
    for row, col in cells:
        values[row - window.row, col - window.col] = value
    return SeenGround(window, values)


def test_the_map_holds_eye_and_seen_cells_and_is_no_strip():
    terrain = sloping()
    seen = patch(Window(10, 15, 70, 60), [(30, 60), (55, 40)])
    data = ground_map(terrain, frame_of(terrain), seen, [MapObserver(20.0, 70.0, 45.0, 50.0)])
    assert 1 / 1.6 < data.size_m[0] / data.size_m[1] < 1.6
    narrow = ground_map(
        terrain, frame_of(terrain), patch(Window(0, 0, 90, 120), [(70, 110)]), [MapObserver(20.0, 70.0)]
    )
    assert narrow.size_m[0] / narrow.size_m[1] == pytest.approx(1.5, rel=0.05)
    observer = data.observers[0]
    assert 0 <= observer.col_px < data.elevation_m.shape[1] and 0 <= observer.row_px < data.elevation_m.shape[0]
    assert data.elevation_m[round(observer.row_px), round(observer.col_px)] == 1000 + 700 + 20
    assert sorted(np.diff(np.argwhere(data.seen), axis=0)[0]) == [-20, 25]


def test_where_nothing_is_seen_the_place_itself_is_shown():
    terrain = sloping()
    data = ground_map(terrain, frame_of(terrain, 60, 45), patch(Window(0, 0, 90, 120), []), [MapObserver(60.0, 45.0)])
    assert min(data.size_m) >= 2 * SMALLEST_M
    assert not data.seen.any()


def test_at_the_edge_the_map_is_moved_and_a_small_dem_is_shown_whole():
    terrain = sloping(40, 400)
    seen = patch(Window(0, 0, 40, 400), [(0, 0), (39, 399)])
    data = ground_map(terrain, frame_of(terrain, 0, 0), seen, [MapObserver(0.0, 0.0)])
    assert data.elevation_m.shape == (40, 400)
    assert (data.observers[0].col_px, data.observers[0].row_px) == (0.0, 0.0)


@settings(deadline=None, max_examples=25)
@given(st.integers(10, 70), st.integers(1, 400))
def test_strips_leave_no_seam(most_cells, strip_cells):
    terrain, window = sloping(), Window(0, 0, 90, 120)
    seen = SeenGround(window, (np.indices((90, 120)).sum(axis=0) % 7 < 4).astype(np.uint8))
    frame, eye = frame_of(terrain), [MapObserver(20.0, 70.0)]
    whole = ground_map(terrain, frame, seen, eye, options=GroundMapOptions(most_cells=most_cells))
    with pytest.MonkeyPatch.context() as patched:
        patched.setattr(figures_ground, "STRIP_CELLS", strip_cells)
        pieces = ground_map(terrain, frame, seen, eye, options=GroundMapOptions(most_cells=most_cells))
    np.testing.assert_array_equal(whole.elevation_m, pieces.elevation_m)
    np.testing.assert_array_equal(whole.seen, pieces.seen)
    assert max(whole.elevation_m.shape) <= most_cells


def test_a_reduced_cell_is_the_mean_of_its_block_and_seen_where_half_of_it_is():
    terrain = sloping()
    terrain.elevation_m[0, 0] = np.nan
    values = np.zeros((90, 120), np.uint8)
    values[0:2, 0:1], values[0:2, 2], values[0, 4] = 3, 255, 5
    seen = SeenGround(Window(0, 0, 90, 120), values)
    eyes = [MapObserver(0.0, 0.0), MapObserver(119.0, 89.0)]
    data = ground_map(terrain, frame_of(terrain), seen, eyes, options=GroundMapOptions(2, 60))
    assert data.elevation_m[0, 0] == pytest.approx(np.mean([1001, 1010, 1011]))
    assert data.elevation_m[5, 7] == pytest.approx(terrain.elevation_m[10:12, 14:16].mean())
    assert data.seen[0, :3].tolist() == [3, 0, 0]
    assert data.observers[0].col_px == pytest.approx(-0.25) and data.observers[1].row_px == pytest.approx(44.25)
    assert data.cell_xy_m == pytest.approx((60.0, 60.0))


def test_other_places_are_thinned_and_the_track_is_cut_to_the_surroundings():
    terrain = sloping()
    seen = patch(Window(0, 0, 90, 120), [(40, 40)])
    others = [MapObserver(21.0 + 0.001 * k, 60.0, beside=True) for k in range(500)]
    away = [MapObserver(5000.0, 5000.0, beside=True)]
    track = np.array([[5000.0, 5000.0], [5001.0, 5001.0], [22.0, 60.0], [22.1, 60.1], [20.0, 70.0]])
    data = ground_map(terrain, frame_of(terrain), seen, [MapObserver(20.0, 70.0), *others, *away], track)
    assert 2 <= len(data.observers) <= 4
    assert np.isfinite(data.track_px).all(axis=1).sum() == 2
    assert ground_map(terrain, frame_of(terrain), seen, [MapObserver(20.0, 70.0)], track[:2]).track_px is None


def test_packed_cells_serve_as_an_array_does():
    from skyline_viewshed.core.viewshed.sinks import PackedSink

    terrain, window = sloping(), Window(7, 9, 70, 101)
    values = (np.indices((70, 101)).sum(axis=0) % 5 < 3).astype(np.uint8)
    values[40:, 50:] = 255
    packed = PackedSink(window)
    packed.add(window, values)
    frame, eye = frame_of(terrain), [MapObserver(20.0, 70.0)]
    one, other = (ground_map(terrain, frame, SeenGround(window, v), eye) for v in (values, packed.values))
    np.testing.assert_array_equal(one.seen, other.seen)
    assert one.seen.any() and one.observers == other.observers


def test_a_raster_that_runs_from_south_to_north_is_turned():
    class SouthUp(ArrayTerrain):
        def frame(self, longitude_deg, latitude_deg, radius_m):
            from dataclasses import replace

            usual = super().frame(longitude_deg, latitude_deg, radius_m)
            turned = np.array([[1, 1], [-1, -1]]) * usual.jacobian_px_per_m
            return replace(usual, row_px=self.shape[0] - 1 - usual.row_px, jacobian_px_per_m=turned)

    usual, turned = sloping(), SouthUp(sloping().elevation_m[::-1], 30.0)
    whole = Window(0, 0, 90, 120)
    one = ground_map(usual, frame_of(usual), patch(whole, [(30, 60)]), [MapObserver(20.0, 70.0)])
    frame = turned.frame(*usual.position_of(20.0, 70.0), 10_000.0)
    other = ground_map(turned, frame, patch(whole, [(59, 60)]), [MapObserver(20.0, 19.0)])
    np.testing.assert_array_equal(one.elevation_m, other.elevation_m)
    np.testing.assert_array_equal(one.seen, other.seen)
    assert one.observers == other.observers
    assert other.convergence_deg == pytest.approx(0.0, abs=1e-9)


pytest.importorskip("PIL")


def panels(painted, seen=True, height_px=180):
    row, col = np.indices((80, 80))
    elevation = 1500 + 400 * np.sin(col / 9) * np.cos(row / 11)
    visible = (np.hypot(col - 20, row - 60) < 50) & (np.abs(np.degrees(np.arctan2(col - 20, 60 - row)) - 45) < 25)
    data = MapData(
        elevation,
        30.0,
        seen=visible if seen else None,
        observers=(MapObserver(20, 60, 45.0, 50.0),),
        track_px=np.array([[2, 78], [10, 70], [20, 60]]),
    )
    return three_panels(painted().preview, data, height_px, captions=False)


def test_the_panels_look_as_they_did(painted, golden_difference):
    mean, worst = golden_difference("panels", panels(painted))
    assert mean < 1
    assert worst < 25


def test_the_viewshed_is_in_the_third_panel_only(painted):
    changed = np.abs(panels(painted).astype(int) - panels(painted, seen=False)).max(axis=(0, 2)) > 20
    photo_px = round(180 * 256 / 192)
    assert not changed[: photo_px + GAP_PX + 180].any()
    assert changed[photo_px + 2 * GAP_PX + 180 :].any()


def test_panels_share_one_height(painted):
    assert panels(painted, height_px=181).shape[0] == 181
