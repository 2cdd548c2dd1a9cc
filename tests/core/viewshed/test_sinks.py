"""Two bits per cell hold what a byte holds, and read like an array."""

import json
import subprocess
import sys

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.base.terrain import Window
from skyline_viewshed.core.viewshed.sinks import PackedSink, SeenCount


@settings(max_examples=40, deadline=None)
@given(st.integers(0, 9), st.integers(1, 30), st.integers(1, 30), st.integers(0, 10_000), st.data())
def test_any_piece_reads_as_it_was_written(left, rows, cols, seed, data):
    window = Window(5, left, rows, cols)
    values = np.random.default_rng(seed).choice(np.array([0, 1, 255], np.uint8), (rows, cols))
    sink = PackedSink(window)
    half = data.draw(st.integers(0, cols))
    for first, last in ((0, half), (half, cols)):
        if first < last:
            sink.add(Window(5, left + first, rows, last - first), values[:, first:last])
    row, col = data.draw(st.integers(0, rows)), data.draw(st.integers(0, cols))
    assert sink.values.shape == values.shape and sink.dtype == values.dtype
    np.testing.assert_array_equal(sink.values[:, :], values)
    np.testing.assert_array_equal(sink.values[row:, :col], values[row:, :col])
    np.testing.assert_array_equal(sink.values[:row, col:], values[:row, col:])
    np.testing.assert_array_equal(sink.values[row : row + 3], values[row : row + 3])


def test_a_single_cell_is_set_anew():
    sink = PackedSink(Window(0, 3, 4, 4))
    sink.set(2, 5, 255)
    sink.set(2, 5, 1)
    assert sink.values[2:3, 2:3] == 1 and sink.values[:, :].sum() == 1


GIGAPIXELS = """
import json, sys
import numpy as np
from osgeo import gdal, osr
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.viewshed.viewshed import PackedSink, ViewshedOptions, Wedge, viewshed
from skyline_viewshed.core.viewshed.sinks import SeenCount

folder = sys.argv[1]
utm = osr.SpatialReference()
utm.ImportFromEPSG(32632)
small = gdal.GetDriverByName("GTiff").Create(folder + "/small.tif", 40, 40, 1, gdal.GDT_Float32)
small.SetProjection(utm.ExportToWkt())
small.SetGeoTransform((400000, 5000, 0, 5400000, 0, -5000))
small.GetRasterBand(1).WriteArray(np.add.outer(np.arange(40.0), -np.arange(40.0)).astype("f4") * 20)
small = None
gdal.Translate(folder + "/big.vrt", folder + "/small.tif", format="VRT", width=40000, height=40000)
dem = open_dem(folder + "/big.vrt")
eye = Observer(*map(float, dem.position_of(4000, 36000)), eye_elevation_m=12000.0)
seen = viewshed(dem, eye, Wedge(45.0, 0.2), ViewshedOptions(max_distance_m=165000.0), sink=PackedSink)
count = SeenCount(dem.shape)
count.add(seen.window, seen.values)
far = count.strip(20000, 256)[0]
facts = seen.window.rows * seen.window.cols, int((far == 1).sum())
print(json.dumps([*facts, int(open("/proc/self/status").read().split("VmHWM:")[1].split()[0]) / 1024]))
"""


def test_a_window_of_half_a_billion_cells_of_a_gigapixel_raster_stays_small(tmp_path):
    script = [sys.executable, "-c", GIGAPIXELS, str(tmp_path)]
    done = subprocess.run(script, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    cells, seen_far, memory_mb = json.loads(done.stdout.splitlines()[-1])
    assert cells > 500_000_000
    assert seen_far > 256 * 20  # the wedge is some forty cells wide there
    assert memory_mb < 600, "a byte per cell alone would take 550"


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 2**31), st.integers(1, 700), st.integers(1, 600), st.integers(1, 4))
def test_counts_equal_those_of_whole_arrays(seed, rows, cols, photos):
    rng = np.random.default_rng(seed)
    count = SeenCount((rows, cols))
    seen, unknown = np.zeros((rows, cols), int), np.zeros((rows, cols), bool)
    for _ in range(photos):
        top, left = int(rng.integers(rows)), int(rng.integers(cols))
        window = Window(top, left, int(rng.integers(1, rows - top + 1)), int(rng.integers(1, cols - left + 1)))
        values = rng.choice(np.array([0, 1, 255], np.uint8), (window.rows, window.cols))
        count.add(window, values)
        place = slice(top, top + window.rows), slice(left, left + window.cols)
        seen[place] += values == 1
        unknown[place] |= values == 255
    first = int(rng.integers(rows))
    last = int(rng.integers(first, rows)) + 1
    found, doubt = count.strip(first, last - first)
    np.testing.assert_array_equal(found, seen[first:last])
    np.testing.assert_array_equal(doubt, unknown[first:last] & (seen[first:last] == 0))


def test_ground_that_nobody_looks_at_takes_no_memory():
    count = SeenCount((10_000_000, 10_000_000))
    count.add(Window(9_999_990, 9_999_990, 10, 10), np.ones((10, 10), np.uint8))
    seen, unknown = SeenCount((5, 5)).strip(0, 5)
    assert len(count._tiles) == 1 and not seen.any() and not unknown.any()
