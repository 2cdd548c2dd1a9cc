from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.frame import tabulate_frame
from skyline_viewshed.core.base.posed import PosedPhoto
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer, Window
from skyline_viewshed.core.base.view import open_view
from skyline_viewshed.core.base.viewed import Viewshed
from skyline_viewshed.core.mapping.drape import Mosaic, drape_photo
from skyline_viewshed.core.mapping.monoplot import place_pixels
from skyline_viewshed.core.mapping.picture import build_picture_pyramid

CAMERA = Camera(400, 300, 300.0)
SIZE = 301


def plane():
    return ArrayTerrain(np.zeros((SIZE, SIZE), np.float32), 2.0)


def view_of(terrain, pose=None, eye_m=60.0):
    pose = pose or Pose(0.0, -30.0)
    return open_view(terrain, PosedPhoto(CAMERA, pose, Observer(0, 0, eye_m)), 500.0)


def whole():
    return Window(0, 0, SIZE, SIZE)


def seen_ground(mask, window):
    """A viewshed as far as draping asks of it."""
    return Viewshed(window, mask.astype(np.uint8), None, 0.0, None, None)


def stripes():
    """A picture whose red and green say where a pixel lies."""
    y, x = np.mgrid[:300, :400]
    return np.stack([x * 255 // 399, y * 255 // 299, np.full(x.shape, 80)], -1).astype(np.uint8)


def draped(terrain, view, picture, seen=None, refine=1, mosaic=None):
    mosaic = mosaic or Mosaic(whole(), refine)
    seen = np.ones((SIZE, SIZE), bool) if seen is None else seen
    count = drape_photo(mosaic, terrain, view, build_picture_pyramid(picture), seen_ground(seen, whole()))
    return mosaic, count, *mosaic.read(0, mosaic.shape[0])


def test_each_cell_has_the_colour_of_the_pixel_that_sees_it():
    terrain = plane()
    view = view_of(terrain)
    _, count, rgba, _ = draped(terrain, view, stripes())
    assert count == (rgba[..., 3] == 255).sum() > 1000
    x, y = np.array([60.0, 200.0, 350.0]), np.array([150.0, 180.0, 260.0])
    placed = place_pixels(terrain, view, x, y)
    col, row = view.frame.to_pixel(placed.hits.east_m, placed.hits.north_m)
    for k in range(3):
        cell = rgba[int(np.rint(row[k])), int(np.rint(col[k]))]
        # A cell of 2 m is a few pixels here, and so are the steps of the picture's colours.
        assert abs(int(cell[0]) - x[k] * 255 / 399) < 6 and abs(int(cell[1]) - y[k] * 255 / 299) < 6


def test_unseen_cells_stay_transparent_and_without_distance():
    terrain = plane()
    seen = np.zeros((SIZE, SIZE), bool)
    seen[100:110, 145:155] = True
    _, count, rgba, gsd = draped(terrain, view_of(terrain), stripes(), seen)
    assert count == 100
    assert ((rgba[..., 3] == 255) == seen).all() and (np.isfinite(gsd[0]) == seen).all()
    assert (rgba[~seen] == 0).all()


def test_sampling_distances_follow_from_the_geometry():
    terrain = plane()
    _, _, _, gsd = draped(terrain, view_of(terrain), stripes())
    # The optical axis meets the plane at 30 degrees, 60 / tan 30 = 104 m north: row 150 - 52.
    slant = 60 / np.sin(np.radians(30))
    assert gsd[0, 98, 150] == pytest.approx(slant / 300, rel=0.02)
    assert gsd[1, 98, 150] == pytest.approx(slant / 300 / np.sin(np.radians(30)), rel=0.02)


def test_a_large_cell_takes_the_mean_of_its_pixels():
    terrain = ArrayTerrain(np.zeros((SIZE, SIZE), np.float32), 2.0)
    checks = np.where((np.indices((300, 400)).sum(axis=0) % 2)[..., None], 255, 0).astype(np.uint8)
    picture = np.repeat(checks, 3, axis=2)
    view = view_of(terrain, Pose(0.0, -60.0), eye_m=20.0)  # a cell covers some 30 pixels
    _, count, rgba, _ = draped(terrain, view, picture)
    inner = rgba[rgba[..., 3] == 255][:, 0]
    assert count > 30 and np.abs(inner.astype(int) - 128).max() < 30


def test_a_finer_raster_shows_more_of_the_picture_in_the_same_place():
    terrain = plane()
    view = view_of(terrain)
    _, coarse_count, coarse, _ = draped(terrain, view, stripes())
    mosaic, fine_count, fine, _ = draped(terrain, view, stripes(), refine=3)
    assert mosaic.shape == (3 * SIZE, 3 * SIZE)
    assert fine_count == pytest.approx(9 * coarse_count, rel=0.03)
    both = (coarse[..., 3] == 255) & (fine[1::3, 1::3, 3] == 255)
    assert np.abs(coarse[both].astype(int) - fine[1::3, 1::3][both].astype(int)).max() <= 6


def test_of_two_photos_the_nearer_one_wins_and_order_does_not_matter():
    terrain = plane()
    far, near = view_of(terrain, eye_m=150.0), view_of(terrain, eye_m=40.0)
    red, blue = np.zeros((300, 400, 3), np.uint8), np.zeros((300, 400, 3), np.uint8)
    red[..., 0], blue[..., 2] = 200, 200
    first, *_ = draped(terrain, far, red)
    *_, one, gsd = draped(terrain, near, blue, mosaic=first)
    second, *_ = draped(terrain, near, blue)
    *_, other, gsd_other = draped(terrain, far, red, mosaic=second)
    assert np.abs(one.astype(int) - other.astype(int)).max() <= 1
    assert np.array_equal(gsd, gsd_other, equal_nan=True)
    assert one[115, 150, 2] > 150 > one[115, 150, 0]


def test_a_reduced_copy_of_the_picture_gives_the_same_colours():
    terrain = plane()
    view = view_of(terrain)
    _, _, full, _ = draped(terrain, view, stripes())
    small = build_picture_pyramid(stripes()).levels[1]
    _, _, reduced, _ = draped(terrain, view, small)
    assert np.abs(full.astype(int) - reduced.astype(int)).max() <= 4


def test_only_touched_tiles_take_memory():
    big = 2000
    terrain = ArrayTerrain(np.zeros((big, big), np.float32), 2.0)
    view = open_view(terrain, PosedPhoto(CAMERA, Pose(0.0, -30.0), Observer(0, 0, 60.0)), 500.0)
    seen = np.zeros((big, big), bool)
    seen[930:950, 990:1010] = True
    mosaic = Mosaic(Window(0, 0, big, big))
    drape_photo(mosaic, terrain, view, build_picture_pyramid(stripes()), seen_ground(seen, Window(0, 0, big, big)))
    assert 1 <= len(mosaic.tiles) <= 2
    rgba, gsd = mosaic.read(900, 100)
    assert rgba.shape == (100, big, 4) and gsd.shape == (2, 100, big)
    assert (rgba[30:50, 990:1010, 3] == 255).all()


def test_a_bent_frame_is_followed_between_its_nodes():
    terrain = plane()

    def transform(east, north):
        return 150 + (east + 2e-4 * east**2) / 2.0, 150 - (north + 3e-4 * east * north) / 2.0

    class Bent(ArrayTerrain):
        def frame(self, longitude_deg, latitude_deg, radius_m):
            return tabulate_frame(longitude_deg, latitude_deg, transform, radius_m)

    bent = Bent(terrain.elevation_m, 2.0)
    view = view_of(bent)
    assert view.frame.remainder_px is not None
    _, _, rgba, _ = draped(bent, view, stripes())
    x, y = 90.0, 180.0
    placed = place_pixels(bent, view, np.array([x]), np.array([y]))
    col, row = view.frame.to_pixel(placed.hits.east_m, placed.hits.north_m)
    cell = rgba[int(np.rint(row[0])), int(np.rint(col[0]))]
    assert abs(int(cell[0]) - x * 255 / 399) < 6 and abs(int(cell[1]) - y * 255 / 299) < 6


def test_cells_at_pixels_that_show_sky_stay_transparent():
    terrain = plane()
    view = view_of(terrain)
    sky = np.zeros((30, 40), bool)
    sky[:15] = True
    _, _, whole_rgba, _ = draped(terrain, view, stripes())
    mosaic = Mosaic(whole())
    picture = build_picture_pyramid(stripes(), sky=sky)
    drape_photo(mosaic, terrain, view, picture, seen_ground(np.ones((SIZE, SIZE), bool), whole()))
    rgba, gsd = mosaic.read(0, SIZE)
    seen, kept = whole_rgba[..., 3] > 0, rgba[..., 3] > 0
    row, col = np.nonzero(seen)
    _, y = view.pixel_of(*view.frame.to_local(col, row), np.zeros(row.size))
    assert (kept[row, col] == (y >= 149.5)).all() and not kept[~seen].any() and kept.sum() > 1000
    assert np.isnan(gsd[:, ~kept]).all()
