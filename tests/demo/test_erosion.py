from __future__ import annotations

import numpy as np
from skyline_viewshed.demo.erosion import drainage, slide, wear


def test_drainage_of_a_plane_runs_straight_down_and_leaves_a_pit_by_its_lowest_rim():
    plane = np.add.outer(np.arange(6.0), np.zeros(7)) + 0.01 * np.arange(7)
    receiver, length = drainage(plane)
    assert receiver[3 * 7 + 3] in (2 * 7 + 3, 2 * 7 + 2)
    assert (receiver[:7] == 42).all() and receiver[42] == 42
    pit = np.full((5, 5), 9.0)
    pit[2, 2:] = 1.0, 4.0, 8.0
    receiver, length = drainage(pit)
    assert receiver[2 * 5 + 2] == 2 * 5 + 3
    assert length[2 * 5 + 2] == 1.0


def test_uplift_and_rivers_come_to_a_balance():
    generator = np.random.Generator(np.random.PCG64(2))
    height, even = generator.random((40, 40)), np.ones((40, 40))
    means = []
    for _ in range(160):
        height = wear(height, even, even, 300.0, 0.8)
        means.append(height.mean())
    assert means[60] > means[5]
    assert abs(means[-1] / means[-20] - 1) < 0.02
    assert height[0].max() < height[15:25, 15:25].mean()


def test_slides_keep_the_mass_and_lower_what_is_too_steep():
    heap = np.zeros((21, 21))
    heap[10, 10] = 1000.0
    after = slide(heap, 30.0, 0.7, passes=200)
    assert abs(after.sum() - 1000.0) < 1e-6
    assert np.abs(np.diff(after, axis=0)).max() < 2 * 0.7 * 30.0
