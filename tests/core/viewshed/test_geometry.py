import numpy as np
import pytest
from skyline_viewshed.core.base.errors import UnusableDemError
from skyline_viewshed.core.base.frame import tabulate_frame
from skyline_viewshed.core.viewshed.geometry import quarters, tabulated
from skyline_viewshed.core.viewshed.sector import Wedge

RADIUS_M = 20_000.0


def plane(turn_deg=0.0, cell=(20.0, 20.0)):
    """Frame of a plane grid turned by `turn_deg`, its cells not square on request."""
    c, s = np.cos(np.radians(turn_deg)), np.sin(np.radians(turn_deg))
    return tabulate_frame(
        0, 0, lambda e, n: (500.3 + (c * e - s * n) / cell[0], 400.6 - (s * e + c * n) / cell[1]), RADIUS_M, size=65
    )


def bent(strength=1.0):
    """Frame of a grid whose lines bend by some hundred metres and whose scale drifts by percents."""
    return tabulate_frame(
        0, 0,
        lambda e, n: (500.3 + (e + strength * 1e-6 * n**2) / 20, 400.6 - (n * (1 + strength * 1e-6 * e)) / 20),
        RADIUS_M, size=129,
    )  # fmt: skip


def all_quarters(frame, k_max=600.0, touches=None):
    far = {(rows, sign): k_max for rows in (True, False) for sign in (-1, 1)}
    return [tabulated(frame, quarter, k_max) for quarter in quarters(frame, far, touches)]


@pytest.mark.parametrize("frame", [plane(), plane(33.0), plane(0.0, (10.0, 25.0)), bent()])
def test_every_cell_belongs_to_exactly_one_quarter(frame):
    row, col = np.mgrid[300:500, 400:600]
    owners = np.zeros(row.shape, int)
    for quarter in all_quarters(frame):
        line, along = (row, col) if quarter.by_rows else (col, row)
        k = quarter.sign * (line - quarter.origin_line)
        owners += (k > 0) & quarter.owns(along - quarter.origin_along, np.abs(line - quarter.origin_line))
    assert (owners == 1).all()


def test_a_plane_grid_needs_no_tables():
    for quarter in all_quarters(plane(33.0)):
        assert quarter.plane
        col, row = quarter.to_pixel(3.0, 40.0)
        east, north = plane(33.0).to_local(col, row)
        assert np.hypot(east, north) == pytest.approx(40.0 * quarter.rho_m(3.0 / 40.0), rel=1e-6)
        assert np.degrees(np.arctan2(east, north)) == pytest.approx(quarter.azimuth_deg(3.0 / 40.0), abs=1e-4)


def test_on_a_bent_grid_a_ray_keeps_its_azimuth_and_its_distances_are_true():
    frame = bent()
    for quarter in all_quarters(frame):
        assert not quarter.plane
        for u in (quarter.u_min, -0.4, 0.0, 0.73, quarter.u_max):
            place = quarter.ray_bend.place(np.array([u]))
            for k in (30.0, 250.0, 600.0):
                w = u + float(quarter.ray_bend.along(quarter.ray_bend.line(k), place)[0])
                east, north = frame.to_local(*quarter.to_pixel(w * k, k), iterations=8)
                turn = (np.degrees(np.arctan2(east, north)) - quarter.azimuth_deg(u) + 180) % 360 - 180
                assert abs(turn) < 0.01
                stretch = float(quarter.ray_stretch.along(quarter.ray_stretch.line(k), place)[0])
                assert k * quarter.rho_m(u) * (1 + stretch) == pytest.approx(np.hypot(east, north), rel=2e-4)


def test_cells_and_rays_agree_on_who_meets_whom():
    for quarter in all_quarters(bent()):
        for w, k in ((0.0, 100.0), (0.5, 333.0), (-0.9, 599.0)):
            place = quarter.bend.place(np.array([w]))
            u = w + float(quarter.bend.along(quarter.bend.line(k), place)[0])
            back = u + float(quarter.ray_bend.along(quarter.ray_bend.line(k), quarter.ray_bend.place(np.array([u])))[0])
            assert back == pytest.approx(w, abs=2e-4)


def test_the_rays_reach_the_cells_where_two_quarters_meet():
    for quarter in all_quarters(bent()):
        for w in (-quarter.w_limit, quarter.w_limit):
            place = quarter.bend.place(np.array([w]))
            u = [w + float(quarter.bend.along(quarter.bend.line(k), place)[0]) for k in (30.0, 300.0, 600.0)]
            assert quarter.u_min <= min(u) and max(u) <= quarter.u_max


def test_a_grid_that_folds_sight_lines_is_refused_with_a_remedy():
    with pytest.raises(UnusableDemError, match="UTM"):
        all_quarters(bent(60.0))


@pytest.mark.parametrize("heading_deg, width_deg, count", [(2.0, 40.0, 1), (45.0, 20.0, 2), (200.0, 200.0, 3)])
def test_quarters_outside_the_sector_are_left_out(heading_deg, width_deg, count):
    frame = bent()
    some = all_quarters(frame, 300.0, Wedge(heading_deg, width_deg).touches)
    assert len(some) == count
    whole = {(quarter.by_rows, quarter.sign): quarter for quarter in all_quarters(frame, 300.0)}
    for quarter in some:
        assert np.array_equal(quarter.bend.values, whole.pop((quarter.by_rows, quarter.sign)).bend.values)
    for quarter in whole.values():  # none of its rays runs in the sector
        azimuth = quarter.azimuth_deg(np.linspace(quarter.u_min, quarter.u_max, 500))
        assert not Wedge(heading_deg, width_deg).accepts(azimuth, None, None).any()
