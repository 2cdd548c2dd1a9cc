import numpy as np
import pytest
from skyline_viewshed.core.base.terrain import ArrayTerrain, Window
from skyline_viewshed.core.viewshed.geometry import quarters, tabulated
from skyline_viewshed.core.viewshed.slabs import Slabs, SweptGround, transposed


@pytest.mark.parametrize("by_rows", [True, False])
@pytest.mark.parametrize("sign", [-1, 1])
def test_slabs_hold_the_lines_of_the_raster_outwards(by_rows, sign):
    rows, cols = 700, 900
    terrain = ArrayTerrain(np.random.default_rng(1).normal(0, 99, (rows, cols)).astype(np.float32), 10.0)
    frame = terrain.frame(*terrain.position_of(430.0, 340.0), 9_000.0)
    (plane,) = quarters(frame, {(by_rows, sign): 300.0})
    quarter = tabulated(frame, plane, 300.0)
    u = np.linspace(quarter.u_min, quarter.u_max, 700).astype(np.float32)
    slabs = Slabs(SweptGround(terrain, quarter, Window(0, 0, rows, cols), 300.0), u, np.ones(len(u), bool))
    grid = terrain.elevation_m if by_rows else terrain.elevation_m.T
    for lines in slabs.lines()[:3]:
        cells, start = slabs.read_transient(lines)
        last = min(start + cells.shape[1], grid.shape[1])
        assert np.array_equal(cells[:, max(-start, 0) : last - start], grid[lines, max(start, 0) : last])


def test_a_transposed_array_is_that_of_numpy():
    values = np.random.default_rng(2).integers(0, 9, (33, 1000)).astype(np.uint8)
    assert np.array_equal(transposed(values), values.T)
