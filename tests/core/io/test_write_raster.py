"""GeoTIFFs on a DEM's grid: exact, whole or not at all."""

import os

import numpy as np
import pytest
from osgeo import gdal
from skyline_viewshed.core.base.errors import OutputError
from skyline_viewshed.core.base.terrain import Window
from skyline_viewshed.core.io import write_raster as module
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.io.write_raster import RasterLayout, new_raster, write_raster
from skyline_viewshed.demo.dem_file import write_dem


@pytest.fixture
def dem(tmp_path):
    relief = np.random.default_rng(5).normal(2000, 300, (300, 400)).astype(np.float32)
    relief[10, 20] = np.nan
    write_dem(tmp_path / "dem.tif", relief, 30.0, 8.0, 46.0)
    return open_dem(tmp_path / "dem.tif")


@pytest.mark.parametrize("dtype", ["uint8", "uint16", "int16", "int32", "float32"])
def test_values_window_and_header_come_back(tmp_path, dem, dtype):
    values = np.random.default_rng(1).integers(0, 200, (2, 120, 90)).astype(dtype)
    window = Window(33, 44, 120, 90)
    write_raster(
        tmp_path / "out.tif",
        values,
        dem,
        window,
        RasterLayout(nodata=255, descriptions=["seen", "times"], metadata={"METHOD": "robust"}),
    )
    found = gdal.Open(str(tmp_path / "out.tif"))
    assert np.array_equal(found.ReadAsArray(), values)
    assert [found.GetRasterBand(band).GetDescription() for band in (1, 2)] == ["seen", "times"]
    assert found.GetRasterBand(2).GetNoDataValue() == 255
    assert found.GetMetadataItem("METHOD") == "robust"
    compression = "PACKBITS" if dtype == "uint8" else "DEFLATE"
    assert found.GetMetadataItem("COMPRESSION", "IMAGE_STRUCTURE") == compression
    assert found.GetRasterBand(1).GetBlockSize() == [256, 256]
    x0, dx, _, y0, _, dy = dem.geotransform
    assert found.GetGeoTransform() == pytest.approx((x0 + 44 * dx, dx, 0, y0 + 33 * dy, 0, dy))
    assert found.GetSpatialRef().IsSame(gdal.Open(dem.path).GetSpatialRef())


def test_the_whole_grid_and_kind_conversions(tmp_path, dem):
    write_raster(tmp_path / "bool.tif", np.ones(dem.shape, bool), dem)
    assert gdal.Open(str(tmp_path / "bool.tif")).GetRasterBand(1).DataType == gdal.GDT_Byte
    write_raster(tmp_path / "double.tif", np.ones(dem.shape), dem)
    assert gdal.Open(str(tmp_path / "double.tif")).GetRasterBand(1).DataType == gdal.GDT_Float32


def test_strips_give_the_same_file_as_the_whole(tmp_path, dem):
    values = np.arange(300 * 400, dtype=np.float32).reshape(300, 400)
    with new_raster(tmp_path / "strips.tif", dem) as file:
        for row in range(0, 300, 70):
            file.write(values[row : row + 70], row=row)
    assert np.array_equal(gdal.Open(str(tmp_path / "strips.tif")).ReadAsArray(), values)


def test_a_wrong_shape_or_type_is_the_programmers_fault(tmp_path, dem):
    with pytest.raises(ValueError, match="does not suit"):
        write_raster(tmp_path / "a.tif", np.zeros((3, 3)), dem)
    with pytest.raises(ValueError, match="does not suit"):
        write_raster(tmp_path / "a.tif", np.zeros(dem.shape, complex), dem)
    assert not (tmp_path / "a.tif").exists()


def test_a_cancelled_or_broken_run_leaves_nothing_and_keeps_the_old_file(tmp_path, dem):
    path = tmp_path / "out.tif"
    write_raster(path, np.ones(dem.shape, np.uint8), dem)
    before = path.read_bytes()
    for stop in (KeyboardInterrupt, ValueError):
        with pytest.raises(stop), new_raster(path, dem, layout=RasterLayout("uint8")) as file:
            file.write(np.zeros((10, 400), np.uint8))
            raise stop
        assert path.read_bytes() == before
        assert sorted(os.listdir(tmp_path)) == ["dem.tif", "out.tif"]


def test_nothing_has_the_final_name_before_the_end(tmp_path, dem):
    with new_raster(tmp_path / "out.tif", dem, layout=RasterLayout("uint8")) as file:
        file.write(np.zeros(dem.shape, np.uint8))
        assert not (tmp_path / "out.tif").exists()
    assert (tmp_path / "out.tif").exists()


def test_a_missing_folder_is_told(dem, tmp_path):
    with pytest.raises(OutputError, match="does not exist"):
        write_raster(tmp_path / "no" / "out.tif", np.zeros(dem.shape, np.uint8), dem)


@pytest.mark.skipif(os.geteuid() == 0, reason="nothing is read-only for root")
def test_a_read_only_folder_is_told(dem, tmp_path):
    folder = tmp_path / "closed"
    folder.mkdir(mode=0o500)
    with pytest.raises(OutputError, match="read-only"):
        write_raster(folder / "out.tif", np.zeros(dem.shape, np.uint8), dem)


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs /dev/full")
def test_a_full_disk_is_told(dem, tmp_path, monkeypatch):
    # The temporary file is a link to a device that is always full.
    real_create = module._create

    def create_on_full_disk(part, *options):
        os.symlink("/dev/full", part)
        return real_create(part, *options)

    monkeypatch.setattr(module, "_create", create_on_full_disk)
    noise = np.random.default_rng(1).integers(0, 255, dem.shape).astype(np.uint8)
    with pytest.raises(OutputError, match="cannot be written"):
        write_raster(tmp_path / "out.tif", noise, dem)
    assert os.listdir(tmp_path) == ["dem.tif"]


def test_names_with_umlauts_emoji_and_200_characters(dem, tmp_path):
    path = tmp_path / ("Sicht 🏔 ü " + "n" * 200 + ".tif")
    write_raster(path, np.ones(dem.shape, np.uint8), dem)
    assert gdal.Open(str(path)) is not None
