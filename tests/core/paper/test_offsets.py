"""Equation 10, its exact counterpart, and the table of means."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px
from skyline_viewshed.core.paper.offsets import angular_offsets, offset_table, pinhole_offsets


def test_equation_10_by_hand():
    offsets = angular_offsets([[1000, 500]], [[1040, 470]], 4000, 3000, 74, 53)
    assert offsets.azimuth_deg[0] == pytest.approx(40 / 4000 * 74)
    assert offsets.elevation_deg[0] == pytest.approx(30 / 3000 * 53)
    assert offsets.total_deg[0] == pytest.approx(np.hypot(0.74, 0.53))


def test_a_synthetic_point_to_the_right_and_below_is_plus_in_azimuth_and_minus_in_elevation():
    offsets = angular_offsets([[0, 0]], [[10, 10]], 100, 100, 50, 50)
    assert offsets.azimuth_deg[0] > 0 > offsets.elevation_deg[0]


def test_each_pair_may_have_its_own_picture():
    offsets = angular_offsets([[0, 0], [0, 0]], [[10, 0], [10, 0]], [100, 200], [100, 100], [50, 50], [40, 40])
    assert offsets.azimuth_deg.tolist() == [5.0, 2.5]


def test_points_that_do_not_pair_and_pictures_without_size_are_refused():
    with pytest.raises(ValueError, match="pair"):
        angular_offsets([[0, 0]], [[0, 0], [1, 1]], 100, 100, 50, 50)
    with pytest.raises(ValueError, match="size"):
        angular_offsets([[0, 0]], [[0, 0]], 0, 100, 50, 50)


def test_the_linear_rule_errs_as_its_docstring_says():
    camera = Camera(4000, 3000, focal_of_fov_px(4000, 74))
    middle, edge = (
        (
            angular_offsets([[x, 1499.5]], [[x + 1, 1499.5]], 4000, 3000, 74, camera.vfov_deg).azimuth_deg[0],
            pinhole_offsets([[x, 1499.5]], [[x + 1, 1499.5]], camera).azimuth_deg[0],
        )
        for x in (1999.0, 3998.5)
    )
    assert middle[0] / middle[1] == pytest.approx(0.86, abs=0.005)
    assert edge[0] / edge[1] == pytest.approx(1.34, abs=0.005)


def test_exact_offsets_on_the_level_axis_are_the_angles_of_the_pinhole():
    camera = Camera(4001, 3001, 2000.0)
    offsets = pinhole_offsets([[2000, 1500]], [[2100, 1500]], camera)
    assert offsets.azimuth_deg[0] == pytest.approx(np.degrees(np.arctan(100 / 2000)))
    assert offsets.elevation_deg[0] == pytest.approx(0)


pixel = st.tuples(st.floats(0, 4000), st.floats(0, 3000))


@given(pixel, pixel, st.floats(0, 360), st.floats(-30, 30), st.floats(-10, 10))
def test_the_exact_total_does_not_depend_on_where_the_camera_looks(first, second, heading, pitch, roll):
    camera = Camera(4000, 3000, 2800.0)
    level = pinhole_offsets([first], [second], camera).total_deg[0]
    turned = pinhole_offsets([first], [second], camera, Pose(heading, pitch, roll)).total_deg[0]
    assert turned == pytest.approx(level, abs=1e-6)


def table():
    extracted = np.zeros((5, 2))
    synthetic = np.array([[30, 0], [-40, 0], [0, 50], [10, 0], [10, 10]])
    names = ["b", "b", "a", "a", "a"]
    return offset_table(names, angular_offsets(extracted, synthetic, 100, 100, 10, 10))


def test_means_are_of_absolute_offsets_and_biases_of_signed_ones():
    first, second = table().photos
    assert (first.name, first.pairs, second.name, second.pairs) == ("b", 2, "a", 3)
    assert first.azimuth_deg == pytest.approx(3.5)
    assert first.bias_azimuth_deg == pytest.approx(-0.5)
    assert second.elevation_deg == pytest.approx(2.0)
    assert second.bias_elevation_deg == pytest.approx(-2.0)


def test_totals_are_means_of_the_pairs_totals():
    second = table().photos[1]
    assert second.total_deg == pytest.approx((5 + 1 + np.sqrt(2)) / 3)


def test_pairs_and_photos_are_averaged_apart():
    result = table()
    assert result.over_pairs.pairs == result.over_photos.pairs == 5
    assert result.over_pairs.azimuth_deg == pytest.approx((3 + 4 + 0 + 1 + 1) / 5)
    assert result.over_photos.azimuth_deg == pytest.approx((3.5 + 2 / 3) / 2)


@given(st.lists(st.tuples(st.floats(-50, 50), st.floats(-50, 50)), min_size=1, max_size=12))
def test_a_total_lies_between_the_root_of_the_squared_means_and_their_sum(shifts):
    """The paper's 2.45 with parts 1.27 and 1.09 cannot be such a mean."""
    offsets = angular_offsets(np.zeros((len(shifts), 2)), shifts, 100, 100, 60, 40)
    means = offset_table(["x"] * len(shifts), offsets).over_pairs
    assert np.hypot(means.azimuth_deg, means.elevation_deg) <= means.total_deg + 1e-9
    assert means.total_deg <= means.azimuth_deg + means.elevation_deg + 1e-9


def test_no_pair_is_refused():
    with pytest.raises(ValueError, match="at least one"):
        offset_table([], angular_offsets(np.zeros((0, 2)), np.zeros((0, 2)), 10, 10, 5, 5))
