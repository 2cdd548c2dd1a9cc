"""The plan of the stations."""

from __future__ import annotations

from xml.etree import ElementTree

import numpy as np
import pytest
from skyline_viewshed.core.figures.stations import Station, stations_svg


def dots(drawing):
    root = ElementTree.fromstring(drawing.replace("<svg ", '<svg xmlns:xlink="l" ', 1))
    return np.array(
        [[float(part.get("cx")), float(part.get("cy"))] for part in root.iter() if part.tag.endswith("circle")]
    )


def stations(*places):
    return [Station(longitude, latitude, f"{index}", "accepted") for index, (longitude, latitude) in enumerate(places)]


def test_east_is_right_north_is_up_and_both_are_to_scale():
    origin, east, north = dots(stations_svg(stations((10, 60), (10.02, 60), (10, 60.01))))
    assert east[0] - origin[0] == pytest.approx(origin[1] - north[1], rel=0.01)  # cos 60 = 1/2
    assert east[1] == pytest.approx(origin[1])
    assert north[0] == pytest.approx(origin[0])


def test_the_scale_bar_says_its_length():
    drawing = stations_svg(stations((10, 0), (10.1, 0)))
    assert "2 km" in drawing
    assert "0 m" not in drawing.replace("10 m", "")


def test_neighbours_across_the_180th_meridian_stay_neighbours():
    first, second = dots(stations_svg(stations((179.999, 0), (-179.999, 0))))
    assert 0 < second[0] - first[0] < 1280
    assert np.allclose(first[1], second[1])


def test_photographs_of_one_place_are_drawn_together():
    first, second = dots(stations_svg(stations((10, 60), (10.00001, 60))))
    assert np.hypot(*(first - second)) < 3


def test_views_open_towards_their_heading():
    drawing = stations_svg([Station(8, 46, "a", "ambiguous", 90.0, 60.0)])
    (view,) = [
        part for part in ElementTree.fromstring(drawing).iter() if part.get("class") == "station-view is-ambiguous"
    ]
    start = np.array(view.get("d")[1:].split("A")[0].split(), float)
    assert start == pytest.approx([640 + 46 * np.cos(np.radians(30)), 210 - 46 * np.sin(np.radians(30))], abs=0.01)


def test_names_are_escaped_and_stations_without_a_place_are_left_out():
    drawing = stations_svg(
        [Station(8, 46, "</svg><script>", "failed", anchor="photo-1"), Station(None, None, "b", "failed")]
    )
    assert "<script>" not in drawing
    assert len(dots(drawing)) == 1
    assert 'xlink:href="#photo-1"' in drawing
    assert stations_svg([Station(None, 5.0, "b", "failed")]) == ""
