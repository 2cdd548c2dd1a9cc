"""What cannot serve as an elevation model: refused in a sentence, however its header is damaged."""

from __future__ import annotations

import os

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from rasters import make_tif, whole
from skyline_viewshed.core.base.errors import UnusableDemError
from skyline_viewshed.core.base.terrain import Window
from skyline_viewshed.core.io.raster import open_dem


def test_what_is_no_dem_is_refused_in_a_sentence(tmp_path, hills):
    (tmp_path / "text.tif").write_text("no raster")
    (tmp_path / "empty.tif").write_bytes(b"")
    cases = {
        "does not exist": (tmp_path / "missing.tif", 1),
        "not a raster": (tmp_path / "text.tif", 1),
        "no band 2": (make_tif(tmp_path / "one.tif", hills), 2),
        "no band 0": (make_tif(tmp_path / "zero.tif", hills), 0),
        "no geographic or projected": (make_tif(tmp_path / "bare.tif", hills, crs=None), 1),
        "projected coordinate reference system": (make_tif(tmp_path / "local.tif", hills, crs=LOCAL_CRS), 1),
        "not georeferenced": (make_tif(tmp_path / "nogt.tif", hills, geotransform=None), 1),
        "rotated": (make_tif(tmp_path / "rot.tif", hills, geotransform=(0, 20, 5, 0, 5, -20)), 1),
        "no valid cell": (make_tif(tmp_path / "void.tif", np.full((50, 60), -5.0, np.float32), nodata=-5.0), 1),
    }
    for message, (path, band) in cases.items():
        with pytest.raises(UnusableDemError, match=message):
            open_dem(path, band)
    with pytest.raises(UnusableDemError, match="not a raster"):
        open_dem(tmp_path / "empty.tif")


LOCAL_CRS = 'LOCAL_CS["site grid",UNIT["metre",1]]'


def test_one_valid_cell_anywhere_is_enough(tmp_path):
    values = np.full((300, 200), -5.0, np.float32)
    values[123, 57] = 800
    assert np.nanmax(whole(open_dem(make_tif(tmp_path / "a.tif", values, nodata=-5.0)))) == 800


def test_a_damaged_file_is_refused_when_its_cells_are_read(tmp_path):
    values = np.random.default_rng(1).normal(1000, 200, (400, 400)).astype(np.float32)
    path = tmp_path / "a.tif"
    make_tif(path, values)
    path.write_bytes(path.read_bytes()[: values.nbytes // 2])
    with pytest.raises(UnusableDemError):
        whole(open_dem(path))


def test_paths_with_spaces_umlauts_and_emoji(tmp_path, hills):
    folder = tmp_path / ("Höhen 🏔 " + "x" * 150)
    folder.mkdir()
    assert open_dem(make_tif(folder / "dem ä.tif", hills)).shape == (60, 80)


@settings(max_examples=150, deadline=None, derandomize=True, database=None)
@given(st.data())
def test_no_damaged_header_does_worse_than_a_sentence(tmp_path_factory, data):
    folder = tmp_path_factory.getbasetemp()
    rows, cols = np.mgrid[0:24, 0:24]
    source = folder / "fuzz-source.tif"
    if not source.exists():
        make_tif(source, (1500 + 20 * rows + 3 * cols).astype(np.int16))
    content = bytearray(source.read_bytes())
    for _ in range(data.draw(st.integers(1, 4))):
        content[data.draw(st.integers(0, min(len(content), 700) - 1))] = data.draw(st.integers(0, 255))
    path = folder / "fuzz.tif"
    path.write_bytes(bytes(content))
    try:
        dem = open_dem(path)
        dem.read(Window(0, 0, 24, 24).clipped(dem.shape))
    except UnusableDemError as error:
        assert str(error).endswith(".")
    finally:
        for leftover in folder.glob("fuzz.tif.aux.xml"):
            os.remove(leftover)
