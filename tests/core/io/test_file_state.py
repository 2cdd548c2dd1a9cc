"""A kept result notices a change in any file of its DEM, and none where only statistics were written."""

import os
import zipfile

import numpy as np
import pytest
from osgeo import gdal
from rasters import make_tif
from skyline_viewshed.core.io.dem_reading import DemReading
from skyline_viewshed.core.io.file_state import on_disk
from skyline_viewshed.core.io.raster import open_dem

VALUES = np.add.outer(np.arange(40.0), np.arange(50.0)).astype(np.float32) + 500


def sources(folder):
    """The same DEM in every packing: a path for `open_dem` by name."""
    tile = make_tif(folder / "tile.tif", VALUES)
    gdal.BuildVRT(str(folder / "a.vrt"), [tile]).FlushCache()
    gdal.BuildVRT(str(folder / "nested.vrt"), [str(folder / "a.vrt")]).FlushCache()
    pack(folder)
    return {
        "file": tile,
        "VRT": str(folder / "a.vrt"),
        "VRT of a VRT": str(folder / "nested.vrt"),
        "archive": f"/vsizip/{folder}/tile.zip/tile.tif",
        "archive in braces": f"/vsizip/{{{folder}/tile.zip}}/tile.tif",
    }


def pack(folder):
    with zipfile.ZipFile(folder / "tile.zip", "w") as archive:
        archive.write(folder / "tile.tif", "tile.tif")


@pytest.mark.parametrize("packing", ["file", "VRT", "VRT of a VRT", "archive", "archive in braces"])
def test_a_replaced_tile_is_noticed_in_every_packing(tmp_path, packing):
    path = sources(tmp_path)[packing]
    before = open_dem(path).state
    assert open_dem(path).state == before
    make_tif(tmp_path / "tile.tif", VALUES + 1)
    os.utime(tmp_path / "tile.tif", ns=(10**18, 10**18))
    pack(tmp_path)
    os.utime(tmp_path / "tile.zip", ns=(10**18, 10**18))
    assert open_dem(path).state != before


@pytest.mark.parametrize("packing", ["file", "VRT"])
def test_statistics_and_overviews_change_nothing(tmp_path, packing):
    path = sources(tmp_path)[packing]
    before = open_dem(path).state
    dataset = gdal.Open(path)
    dataset.GetRasterBand(1).ComputeStatistics(False)
    dataset.GetRasterBand(1).GetDefaultHistogram()
    dataset.BuildOverviews("NEAREST", [2])
    del dataset
    assert len(list(tmp_path.glob("*.aux.xml"))) + len(list(tmp_path.glob("*.ovr"))) > 0
    assert open_dem(path).state == before


def test_what_a_sidecar_says_of_the_values_does(tmp_path):
    path = make_tif(tmp_path / "a.tif", VALUES)
    before = open_dem(path).state
    dataset = gdal.Open(path)  # read-only, so that GDAL writes a sidecar
    dataset.GetRasterBand(1).SetNoDataValue(520)
    del dataset
    assert (tmp_path / "a.tif.aux.xml").exists()
    assert open_dem(path).state != before


@pytest.mark.parametrize("reading", [{"unit": "feet"}, {"nodata_ranges": ((0.0, 1.0),)}])
def test_another_reading_is_another_dem(tmp_path, reading):
    path = make_tif(tmp_path / "a.tif", VALUES)
    assert open_dem(path).state != open_dem(path, reading=DemReading(**reading)).state


def test_members_of_virtual_systems_are_found_on_the_disk(tmp_path):
    file = tmp_path / "a.tar.gz"
    file.write_bytes(b"x")
    for name in (f"{file}", f"/vsitar/{file}/in/b.tif", f"/vsitar//vsigzip/{file}/b.tif", f"/vsisubfile/10_20,{file}"):
        assert on_disk(name) == str(file), name
    assert on_disk("/vsicurl/https://example.org/a.tif") is None
    assert on_disk("/vsimem/a.tif") is None
