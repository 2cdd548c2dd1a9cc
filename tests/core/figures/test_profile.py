"""Horizon profiles and residuals drawn."""

from __future__ import annotations

import re
from dataclasses import replace
from xml.etree import ElementTree

import numpy as np
import pytest
from skyline_viewshed.core.figures.profile import horizon_profile_svg, residuals_in_words, residuals_svg


def parts(drawing, class_):
    return [part for part in ElementTree.fromstring(drawing).iter() if part.get("class") == class_]


def points_of(path):
    """Absolute points of a path of one stretch."""
    start, steps = re.match(r"M([^l]*)l([^Z]*)", path).groups()
    return np.array(start.split(), float) + np.vstack(
        [[0, 0], np.cumsum(np.array(steps.split(), float).reshape(-1, 2), axis=0)]
    )


def test_the_profile_is_highest_where_the_horizon_is(match_scenes):
    horizon = match_scenes.random_horizon(4)
    horizon.elevation_deg[2345] = 30.0
    (line,) = parts(horizon_profile_svg(horizon), "horizon")
    points = points_of(line.get("d"))
    top = points[np.argmin(points[:, 1])]
    assert top[0] == pytest.approx(44 + 234.5 / 360 * (900 - 70), abs=1.0)


def test_distances_choose_the_colour(match_scenes):
    horizon = match_scenes.random_horizon(4)
    for metres, class_ in ((100, "far0"), (1_500, "far2"), (90_000, "far7")):
        drawing = horizon_profile_svg(replace(horizon, distance_m=np.full(3600, float(metres))))
        paths = [part.get("class") for part in ElementTree.fromstring(drawing).iter() if part.tag.endswith("path")]
        assert [name for name in paths if name.startswith("far")] == [class_]


def test_directions_cut_by_the_dem_and_voids_are_shaded(match_scenes):
    horizon = match_scenes.random_horizon(4)
    horizon.clipped[900:1800] = True
    horizon = replace(horizon, void=np.roll(horizon.clipped, 900))
    drawing = horizon_profile_svg(horizon)
    (cut, _), (void, _) = parts(drawing, "clipped"), parts(drawing, "unknown")  # the second is the key's
    assert float(cut.get("x")) == pytest.approx(44 + 830 / 4, abs=1)
    assert float(cut.get("width")) == pytest.approx(830 / 4, abs=1)
    assert float(void.get("x")) == pytest.approx(44 + 830 / 2, abs=1)


def test_a_view_across_north_is_marked_at_both_ends(match_scenes):
    drawing = horizon_profile_svg(match_scenes.random_horizon(4), heading_deg=5.0, hfov_deg=40.0)
    assert len(parts(drawing, "view")) == 2


def test_coarse_unknown_and_empty_profiles_are_drawn_too(match_scenes):
    coarse = match_scenes.random_horizon(4, step_deg=5.0)
    (line,) = parts(horizon_profile_svg(coarse), "horizon")
    assert len(points_of(line.get("d"))) == 720
    blind = replace(coarse, elevation_deg=np.full(72, np.nan))
    assert "no horizon" in horizon_profile_svg(blind)
    gap = match_scenes.random_horizon(4)
    gap.elevation_deg[100:200] = np.nan
    drawing = horizon_profile_svg(gap)
    ElementTree.fromstring(drawing)
    assert "nan" not in drawing


def test_an_image_skyline_above_the_dem_is_drawn_above_the_line():
    """Rows run downwards: a negative residual is a skyline higher in the picture."""
    drawing = residuals_svg(np.full(100, -3.0), 3000, 52.0)
    (curve,), (zero,) = parts(drawing, "residual"), parts(drawing, "zero")
    assert points_of(curve.get("d"))[:, 1].max() < float(zero.get("y1"))


def test_columns_that_were_not_compared_leave_a_gap():
    residual = np.r_[np.zeros(50), np.full(20, np.nan), np.ones(50)]
    (curve,) = parts(residuals_svg(residual), "residual")
    assert curve.get("d").count("M") == 2


def test_one_wild_run_of_columns_does_not_flatten_the_rest():
    residual = np.r_[np.full(5, 900.0), np.sin(np.arange(995) / 30)]
    (curve,), (zero,) = (parts(residuals_svg(residual), name) for name in ("residual", "zero"))
    inner = points_of(curve.get("d"))[20:]
    assert np.ptp(inner[:, 1]) > 40
    assert points_of(curve.get("d"))[:, 1].min() >= 24


def test_residuals_are_said_in_pixels_degrees_and_shares():
    words = residuals_in_words(np.r_[np.full(75, -5.2), np.full(25, np.nan)], 2600, 52.0)
    assert words == "median 5.2\u00a0px = 0.10° = 0.20 % of the height; 75 % of columns"
    assert residuals_in_words(np.full(4, np.nan)) == "no column compared"
    assert "No column" in residuals_svg(np.full(4, np.nan))
