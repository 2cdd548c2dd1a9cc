"""Placing a line on an edge: ramps and slopes whose place is known in closed form."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.special import ndtr
from skyline_viewshed.core.skyline.appearance import EDGE_SIGMAS_PX, measure
from skyline_viewshed.core.skyline.placing import centre_of_edge, placed_between_rows, row_of_equal_areas

SKY, TERRAIN = np.array([80.0, -5.0, -20.0]), np.array([35.0, 4.0, 10.0])


def ramp(boundary_row, height, blur_px):
    """L*a*b* of sky above terrain with a Gaussian ramp; row y of a boundary is the upper edge of pixel y."""
    edges = (np.arange(height + 1)[:, None] - boundary_row) / blur_px
    # The integral of the normal distribution gives the share of each pixel.
    area = blur_px * (edges * ndtr(edges) + np.exp(-0.5 * edges**2) / np.sqrt(2 * np.pi))
    share = np.diff(area, axis=0)
    return SKY + share[..., None] * (TERRAIN - SKY)


@pytest.mark.parametrize("start", [-1, 0, 1])
def test_the_centre_of_an_edge_is_nearer_than_the_line(start):
    """A ramp between two rows, found by a line up to one row beside it, over texture of equal strength."""
    centre = 20.3
    edge = 0.4 + np.exp(-0.5 * ((np.arange(40) - centre) / 0.9) ** 2)[:, None] * np.ones(6)
    found = centre_of_edge(np.full(6, 20 + start), edge)
    assert np.abs(found - centre).max() < 0.35
    assert np.abs(found - centre).max() <= abs(20 + start - centre)


def test_the_centre_stays_within_reach_where_there_is_no_edge_or_the_picture_ends():
    """No edge moves nothing; rows outside the picture do not count."""
    np.testing.assert_array_equal(centre_of_edge(np.array([0, 5, 9]), np.zeros((10, 3))), [0, 5, 9])
    edge = np.random.default_rng(0).random((10, 3))
    found = centre_of_edge(np.array([0, 5, 9]), edge)
    assert (found >= 0).all() and (found <= 9).all()


@pytest.mark.parametrize(
    ("start", "blur_px", "error_px"), [(0, 0.1, 0.01), (0, 0.6, 0.03), (0, 1.0, 0.1), (1, 0.6, 0.2)]
)
def test_equal_areas_find_the_place_of_a_blurred_step(start, blur_px, error_px):
    """The blur's width hardly matters, nor does a start that is a row away."""
    boundary = 20 + np.linspace(-0.4, 0.4, 9)
    for line in (20.0 - start, 20.0 + start):
        found = row_of_equal_areas(np.full(9, line), ramp(boundary, 40, blur_px))
        np.testing.assert_allclose(found, boundary, atol=error_px)


def test_equal_areas_leave_a_line_alone_without_contrast_or_beside_the_picture():
    """One colour has no step; three rows below the upper edge there are no four rows of sky."""
    line = np.array([3.0, 10.5, 18.0])
    np.testing.assert_array_equal(row_of_equal_areas(line, np.ones((20, 3, 3))), line)
    np.testing.assert_array_equal(row_of_equal_areas(line, ramp(10.0, 20, 0.5)[:, [0, 0, 0]])[[0, 2]], line[[0, 2]])


def test_a_slope_is_placed_to_a_tenth_of_a_row():
    """A line of whole rows along a slope, one row too high, in a picture with noise."""
    boundary = 30 + 0.45 * np.arange(60)
    lab = ramp(boundary, 90, 0.8) + np.random.default_rng(1).normal(0, 1.0, (90, 60, 3))
    edge = np.abs(np.diff(lab[..., 0], axis=0, prepend=lab[:1, :, 0]))
    appearance = SimpleNamespace(edges={EDGE_SIGMAS_PX[0]: edge}, lab=lab)
    line = np.rint(boundary).astype(int) - 1
    error = placed_between_rows(line, appearance) - boundary
    assert np.abs(error[8:-8]).max() < 0.15
    assert np.abs(np.median(error)) < 0.1


def test_a_step_between_two_ridges_stays_sharp():
    """The mean along the columns does not join a near ridge to a far one."""
    boundary = np.where(np.arange(40) < 20, 20.25, 50.75)
    rgb = np.where(np.arange(70)[:, None, None] >= np.rint(boundary)[:, None], 40.0, 200.0) * np.ones(3)
    placed = placed_between_rows(np.rint(boundary).astype(int), measure(rgb.astype(np.float32)))
    np.testing.assert_allclose(placed[:19], 20, atol=0.6)
    np.testing.assert_allclose(placed[21:], 51, atol=0.6)
