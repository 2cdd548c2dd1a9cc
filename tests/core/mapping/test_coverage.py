from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.posed import PosedPhoto
from skyline_viewshed.core.base.terrain import ArrayTerrain, Observer, Window
from skyline_viewshed.core.base.view import open_view
from skyline_viewshed.core.base.viewed import Viewshed
from skyline_viewshed.core.mapping.coverage import Coverage

TERRAIN = ArrayTerrain(np.zeros((60, 80), np.float32), 10.0)
VIEW = open_view(TERRAIN, PosedPhoto(Camera(400, 300, 300.0), Pose(0.0, -45.0), Observer(0, 0, 100.0)), 900.0)
WINDOW = Window(0, 0, 60, 80)


def seen_ground(mask, window=WINDOW):
    """A viewshed as far as the coverage asks of it."""
    return Viewshed(window, mask.astype(np.uint8), None, 0.0, None, None)


def covered(masks, area=None):
    coverage = Coverage(WINDOW, area)
    for k, mask in enumerate(masks):
        coverage.add(f"photo {k}", TERRAIN, VIEW, seen_ground(mask))
    return coverage


def box(top, bottom, left, right):
    mask = np.zeros((60, 80), bool)
    mask[top:bottom, left:right] = True
    return mask


def test_counts_add_up_and_the_rest_is_blind():
    coverage = covered([box(0, 20, 0, 20), box(10, 30, 0, 20)], box(0, 40, 0, 20))
    assert coverage.count[5, 5] == 1 and coverage.count[15, 5] == 2 and coverage.count[35, 5] == 0
    assert coverage.blind.sum() == 10 * 20
    assert np.isfinite(coverage.best_gsd_m).sum() == 30 * 20


def test_the_best_sampling_distance_is_the_nearest_photos():
    near = open_view(TERRAIN, PosedPhoto(Camera(400, 300, 300.0), Pose(0.0, -45.0), Observer(0, 0, 50.0)), 900.0)
    coverage = Coverage(WINDOW)
    coverage.add("far", TERRAIN, VIEW, seen_ground(box(15, 25, 30, 50)))
    first = coverage.best_gsd_m.copy()
    coverage.add("near", TERRAIN, near, seen_ground(box(15, 20, 30, 50)))
    assert (coverage.best_gsd_m[15:20, 30:50] < first[15:20, 30:50]).all()
    assert np.array_equal(coverage.best_gsd_m[20:25, 30:50], first[20:25, 30:50])


def test_viewsheds_of_other_windows_are_put_in_place():
    coverage = Coverage(Window(10, 20, 30, 40))
    seen = np.ones((20, 20), bool)
    assert coverage.add("a", TERRAIN, VIEW, seen_ground(seen, Window(0, 10, 20, 20))) == 10 * 10
    assert coverage.count[:10, :10].all() and coverage.count.sum() == 100
    assert coverage.add("b", TERRAIN, VIEW, seen_ground(np.ones((5, 5), bool), Window(50, 70, 5, 5))) == 0


def fewest_by_trying(masks):
    everything = np.any(masks, axis=0)
    for size in range(1, len(masks) + 1):
        if any(np.array_equal(np.any([masks[k] for k in chosen], axis=0), everything)
               for chosen in combinations(range(len(masks)), size)):  # fmt: skip
            return size
    return 0


def test_greedy_alone_would_take_three_where_two_do():
    # The middle photo shows most, yet both outer ones are needed anyway.
    masks = [box(0, 10, 0, 20), box(0, 10, 20, 40), box(0, 10, 8, 32)]
    chosen, proven, gains = covered(masks).fewest_photos()
    assert sorted(chosen) == [0, 1] and proven
    assert sum(gains) == 400


@pytest.mark.parametrize("seed", range(8))
def test_the_choice_is_as_small_as_trying_all_finds(seed):
    rng = np.random.default_rng(seed)
    masks = []
    for _ in range(9):
        top, left = rng.integers(0, 40), rng.integers(0, 50)
        masks.append(box(top, top + rng.integers(5, 25), left, left + rng.integers(5, 40)))
    chosen, proven, gains = covered(masks).fewest_photos()
    assert proven and len(chosen) == fewest_by_trying(masks)
    assert np.array_equal(np.any([masks[k] for k in chosen], axis=0), np.any(masks, axis=0))
    assert sum(gains) == np.any(masks, axis=0).sum() and min(gains) > 0


def test_nothing_seen_needs_no_photo():
    assert covered([]).fewest_photos() == ([], True, [])
    assert covered([np.zeros((60, 80), bool)]).fewest_photos() == ([], True, [])
