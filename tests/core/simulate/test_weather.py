"""Drawn weather."""

from __future__ import annotations

from skyline_viewshed.core.simulate.scene import CLOUDS, FOREGROUNDS
from skyline_viewshed.core.simulate.weather import hard_scene


def test_hard_scenes_are_seeded_and_cover_all_kinds():
    scenes = [hard_scene(seed) for seed in range(200)]
    assert scenes[7] == hard_scene(7)
    assert {scene.clouds for scene in scenes} == set(CLOUDS)
    assert {scene.foreground for scene in scenes} == set(FOREGROUNDS)
    assert min(s.visibility_m for s in scenes) > 2e4 and max(s.noise for s in scenes) < 8
