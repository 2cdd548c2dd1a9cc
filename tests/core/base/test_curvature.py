"""Earth curvature with refraction, against published and closed-form numbers."""

import numpy as np
import pytest
from skyline_viewshed.core.base.curvature import EARTH_RADIUS_M, apparent_drop_m


@pytest.mark.parametrize("distance_km, drop_m", [(15, 15.4), (60, 245.8), (100, 682.8)])
def test_drop_at_known_distances(distance_km, drop_m):
    assert apparent_drop_m(distance_km * 1000.0) == pytest.approx(drop_m, abs=0.1)


def test_without_refraction_the_drop_is_that_of_the_circle():
    distance = 50_000.0
    exact = EARTH_RADIUS_M * (1 / np.cos(distance / EARTH_RADIUS_M) - 1)
    assert apparent_drop_m(distance, refraction_coefficient=0.0) == pytest.approx(exact, rel=1e-4)


def test_a_ray_as_curved_as_the_earth_sees_no_drop():
    assert apparent_drop_m(1e5, refraction_coefficient=1.0) == 0
