"""The panorama strip: where azimuths, heights, names and photo frames go, in both of its forms."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from types import SimpleNamespace

import numpy as np
import pytest
from skyline_viewshed.core.figures.panorama import (
    PanoramaFrame,
    PanoramaLabel,
    lay_out_panorama,
    panorama_pixels,
    panorama_svg,
)

PX_PER_DEG = 20.0
"""As the strip is drawn unless told otherwise, with north at its left edge."""


def outline(first_deg, last_deg, elevation_deg, distance_m, horizon=True):
    azimuth = np.arange(first_deg, last_deg, 0.5)
    flat = np.ones(azimuth.shape)
    return SimpleNamespace(
        azimuth_deg=azimuth, elevation_deg=elevation_deg * flat, distance_m=distance_m * flat, horizon=horizon
    )


def strip(*outlines, **contents):
    return lay_out_panorama(SimpleNamespace(outlines=outlines), **contents)


def test_azimuth_runs_to_the_right_and_height_upwards_by_one_scale():
    drawn = strip(outline(90, 120, 3.0, 5e3), outline(90, 120, 1.0, 1e3))
    (high_x, high_y, *_), (low_x, low_y, *_) = drawn.lines
    assert drawn.width == 360 * PX_PER_DEG
    assert high_x == pytest.approx(PX_PER_DEG * np.arange(90, 120, 0.5)) and np.array_equal(high_x, low_x)
    assert low_y[0] - high_y[0] == pytest.approx(2.0 * PX_PER_DEG)
    assert drawn.level_y - low_y[0] == pytest.approx(1.0 * PX_PER_DEG)


def test_a_line_across_the_strip_s_ends_is_broken_there_and_nowhere_else():
    (across_x, across_y, *_), (inside_x, *_) = strip(outline(350, 370, 1.0, 5e3), outline(10, 350, 1.0, 5e3)).lines
    (gap,) = np.flatnonzero(np.isnan(across_x))
    assert np.isnan(across_y[gap]) and across_x[gap - 1] > 359 * PX_PER_DEG and across_x[gap + 1] < PX_PER_DEG
    assert np.isfinite(inside_x).all()


def test_far_ridges_are_paler_and_finer_than_near_ones_and_the_horizon_strongest():
    near, far, inner = strip(
        outline(10, 20, 1.0, 400.0), outline(10, 20, 1.0, 60e3), outline(10, 20, 1.0, 400.0, horizon=False)
    ).lines
    assert sum(near[2]) < sum(far[2]) and near[3] > far[3]
    assert near[2] == inner[2] and near[3] > inner[3]


def test_names_point_at_their_summits_and_the_first_of_a_crowd_is_kept():
    crowd = [PanoramaLabel(f"Summit {rank} 4000 m", 100.0, 2.0) for rank in range(60)]
    drawn = strip(outline(0, 360, 2.0, 5e3), labels=crowd)
    assert drawn.labels[0].index == 0 and 1 <= len(drawn.labels) < 60
    assert {label.point_x_px for label in drawn.labels} == {100 * PX_PER_DEG}
    assert all(label.top_px >= 0 and label.left_px + label.width_px <= drawn.width for label in drawn.labels)


def test_the_axis_names_compass_points_and_degrees():
    ticks = dict(strip(outline(0, 360, 1.0, 5e3)).axis)
    assert len(ticks) == 24
    assert ticks[0.0] == "N" and ticks[225 * PX_PER_DEG] == "SW" and ticks[105 * PX_PER_DEG] == "105°"


def test_an_empty_panorama_has_an_axis_all_the_same():
    drawn = strip()
    assert drawn.lines == () and len(drawn.axis) == 24 and 0 < drawn.level_y < drawn.height


def everything():
    turn = np.linspace(0, 2 * np.pi, 50)
    frame = PanoramaFrame("IMG <1>", 45 + 20 * np.cos(turn), 5 * np.sin(turn))
    label = PanoramaLabel("Horn & Co", 200.0, 3.0)
    return strip(outline(0, 360, 3.0, 5e3), labels=[label], frames=[frame])


def test_the_svg_is_well_formed_and_says_what_it_was_given():
    root = ElementTree.fromstring(panorama_svg(everything(), "<title>"))
    words = {element.text for element in root.iter() if element.text}
    assert {"IMG <1>", "Horn & Co", "<title>", "N"} <= words
    paths = [element.get("d") for element in root.iter() if element.tag.endswith("path")]
    assert not [path for path in paths if "nan" in path]
    assert root.get("viewBox").split()[2] == f"{360 * PX_PER_DEG:.0f}"


def test_the_pixels_have_the_lines_where_the_layout_put_them():
    pytest.importorskip("PIL")
    drawn = everything()
    pixels = panorama_pixels(drawn).astype(int)
    assert pixels.shape == (round(drawn.height), round(drawn.width), 3)
    row = round(drawn.level_y - 3.0 * PX_PER_DEG)
    assert np.median(pixels[row - 1 : row + 2, 2000:7000].sum(axis=-1).min(axis=0)) < 500
    assert pixels[5].min() > 240, "sky above"
    orange = (pixels[..., 0] > 180) & (pixels[..., 2] < 90)
    columns = np.flatnonzero(orange.any(axis=0))
    assert abs(columns.min() - 25 * PX_PER_DEG) < 5 and columns.max() < 80 * PX_PER_DEG
