"""Trees and people before the view."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.simulate.foreground import draw_foreground
from skyline_viewshed.core.simulate.scene import SceneOptions


def test_foreground_covers_about_the_share_asked_and_nothing_without():
    ridge = np.full(320, 80.0)
    cover, _ = draw_foreground((240, 320), ridge, SceneOptions(seed=2))
    assert not cover.any()
    for kind in ("trees", "people"):
        cover, colour = draw_foreground((240, 320), ridge, SceneOptions(seed=2, foreground=kind, foreground_share=0.4))
        assert 0.3 < (cover > 0.5).any(axis=0).mean() < 0.9
        assert colour[cover > 0.5].mean() < 0.3


@pytest.mark.parametrize("kind", ["trees", "people"])
def test_what_stands_near_reaches_down_to_the_lower_edge(kind):
    ridge = np.full(320, 80.0)
    cover, _ = draw_foreground((240, 320), ridge, SceneOptions(seed=4, foreground=kind, foreground_share=0.3))
    columns = (cover > 0.5).any(axis=0)
    assert columns.sum() > 20
    standing = cover[-1] > 0.5
    assert standing.sum() > 0.3 * columns.sum()
    assert cover.min() >= 0 and cover.max() <= 1


def test_the_same_seed_draws_the_same_trees():
    ridge = np.linspace(60.0, 120.0, 160)
    scenes = [SceneOptions(seed=seed, foreground="trees") for seed in (5, 5, 6)]
    first, again, other = (draw_foreground((120, 160), ridge, scene)[0] for scene in scenes)
    assert np.array_equal(first, again) and not np.array_equal(first, other)
