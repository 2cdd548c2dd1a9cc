import numpy as np
import pytest
from skyline_viewshed.core.locate.index import UNKNOWN, HorizonIndex, stored_angles, stored_distances


def index():
    angle = np.array([[1.234, -0.5, np.nan], [89.0, 0.0, -12.3]])
    distance = np.array([[123.0, 60_000.0, np.nan], [700_000.0, 5.0, 0.0]])
    place = np.array([8.0, 8.2]), np.array([46.0, 46.1]), np.array([500.0, 600.0])
    return HorizonIndex(*place, stored_angles(angle), stored_distances(distance), 90.0, 270.0)


def test_angles_and_distances_come_back():
    angle, distance = index().horizons(slice(None))
    assert angle[0, :2] == pytest.approx([1.23, -0.5], abs=0.006) and np.isnan(angle[0, 2])
    assert distance[0, :2] == pytest.approx([120.0, 60_000.0])
    assert distance[1, 0] == 655_350.0
    assert index().elevation[0, 2] == UNKNOWN


def test_a_part_is_an_index_of_its_own():
    part = index().take(np.array([1]))
    assert len(part) == 1 and part.longitude_deg[0] == 8.2 and part.spacing_m == 270.0
    assert index().middle_deg == pytest.approx((8.1, 46.05))
