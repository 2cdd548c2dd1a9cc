import os

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import OutputError
from skyline_viewshed.core.io.array_folder import ArrayFolder, mark_of
from skyline_viewshed.core.io.crs import WGS84
from skyline_viewshed.core.io.dem_reading import DemReading
from skyline_viewshed.core.io.raster import open_dem


def fill(folder, value):
    with folder.filling() as hold:
        hold("a", (3, 2), np.int16)[:] = value
        hold("b", (2,), np.float64)[:] = value


def test_arrays_are_read_from_disk_without_loading(tmp_path):
    folder = ArrayFolder(tmp_path / "new" / "index")
    assert folder.read(("a",)) is None
    fill(folder, 7)
    arrays = folder.read(("a", "b"))
    assert isinstance(arrays["a"], np.memmap) and (arrays["a"] == 7).all() and arrays["b"].tolist() == [7.0, 7.0]
    assert folder.read(("a", "c")) is None


def test_a_run_that_fails_leaves_the_older_folder(tmp_path):
    folder = ArrayFolder(tmp_path / "index")
    fill(folder, 1)
    with pytest.raises(RuntimeError), folder.filling() as hold:
        hold("a", (3, 2), np.int16)[:] = 2
        raise RuntimeError
    assert (folder.read(("a",))["a"] == 1).all()
    assert [path.name for path in tmp_path.iterdir()] == ["index"]


def test_a_new_folder_takes_the_place_of_the_older_one(tmp_path):
    folder = ArrayFolder(tmp_path / "index")
    fill(folder, 1)
    fill(folder, 2)
    assert (folder.read(("a",))["a"] == 2).all()


def test_a_damaged_array_counts_as_missing(tmp_path):
    folder = ArrayFolder(tmp_path / "index")
    fill(folder, 1)
    (tmp_path / "index" / "a.npy").write_bytes(b"\x93NUMPY")
    assert folder.read(("a", "b")) is None


def test_a_folder_that_cannot_be_written_is_told(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(OutputError, match="cannot be written"), ArrayFolder(tmp_path / "file" / "index").filling():
        pass


@pytest.fixture
def tile(tmp_path):
    """A tile of heights, and the VRT before it."""
    gdal = pytest.importorskip("osgeo.gdal")
    path = str(tmp_path / "tile.tif")
    dataset = gdal.GetDriverByName("GTiff").Create(path, 40, 40, 1, gdal.GDT_Float32)
    dataset.SetGeoTransform((7.0, 0.001, 0, 46.0, 0, -0.001))
    dataset.SetProjection(WGS84)
    dataset.WriteArray(1000 + np.add.outer(np.arange(40.0), np.arange(40.0)))
    dataset = None
    gdal.BuildVRT(str(tmp_path / "dem.vrt"), [path]).FlushCache()
    return tmp_path / "tile.tif", tmp_path / "dem.vrt"


def test_the_mark_follows_the_tile_behind_a_vrt_the_reading_and_the_facts(tile):
    path, vrt = tile
    first = mark_of(open_dem(vrt), "area")
    assert first == mark_of(open_dem(vrt), "area") != mark_of(open_dem(vrt), "other area")
    assert mark_of(open_dem(vrt, reading=DemReading(unit="feet")), "area") != first
    assert mark_of(open_dem(vrt, reading=DemReading(nodata_ranges=((0.0, 1.0),))), "area") != first
    os.utime(path, (1, 1))
    assert mark_of(open_dem(vrt), "area") != first
