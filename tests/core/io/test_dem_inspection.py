"""Rasters that hold no heights are refused with the right reason, and DEMs of every kind are not."""

import numpy as np
import pytest
from osgeo import gdal, osr
from rasters import make_tif, whole
from skyline_viewshed.core.base.errors import UnusableDemError
from skyline_viewshed.core.io.dem_reading import DemReading
from skyline_viewshed.core.io.raster import open_dem

SIDE = 200


@pytest.fixture
def hills():
    y, x = np.mgrid[:SIDE, :SIDE] / 8.0
    return (1800 + 500 * np.sin(x / 3) * np.cos(y / 4) + 90 * np.sin(x * 1.3 + y)).astype(np.float32)


def refused(path, words, **reading):
    with pytest.raises(UnusableDemError, match=words):
        open_dem(path, reading=DemReading(**reading))


def picture(path, bands, colours=(gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand, gdal.GCI_AlphaBand)):
    make_tif(path, np.zeros((SIDE, SIDE), np.uint8))
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), SIDE, SIDE, len(bands), gdal.GDT_Byte)
    reference = osr.SpatialReference()
    reference.ImportFromEPSG(32632)
    dataset.SetProjection(reference.ExportToWkt())
    dataset.SetGeoTransform((600_000, 30, 0, 5_100_000, 0, -30))
    for number, (values, colour) in enumerate(zip(bands, colours), start=1):
        dataset.GetRasterBand(number).SetColorInterpretation(colour)
        dataset.GetRasterBand(number).WriteArray(np.asarray(values, np.uint8))
    dataset.FlushCache()
    return str(path)


@pytest.mark.parametrize("alpha", [False, True])
def test_a_colour_picture_is_called_one(tmp_path, alpha):
    bands = list(np.random.default_rng(1).integers(0, 255, (4 if alpha else 3, SIDE, SIDE)))
    refused(picture(tmp_path / "a.tif", bands), "is a colour picture")
    refused(tmp_path / "a.tif", "is a colour picture", unit="metres")


@pytest.mark.parametrize("name", ["Mapbox", "Terrarium"])
def test_terrain_rgb_is_named_with_its_formula(tmp_path, hills, name):
    code = np.round((hills + 10_000) * 10 if name == "Mapbox" else (hills + 32_768) * 256).astype(np.int64)
    bands = [code >> 16, code >> 8 & 255, code & 255]
    refused(picture(tmp_path / "a.tif", bands), rf"terrain-RGB, {name}.*raster calculator.*R")


def test_a_palette_is_called_one(tmp_path):
    path = make_tif(tmp_path / "a.tif", np.zeros((SIDE, SIDE), np.uint8))
    dataset = gdal.Open(path, gdal.GA_Update)
    table = gdal.ColorTable()
    table.SetColorEntry(0, (10, 20, 30))
    dataset.GetRasterBand(1).SetColorTable(table)
    del dataset
    refused(path, "colour palette")


def test_eight_bits_are_refused_unless_a_unit_is_chosen_or_recorded(tmp_path, hills):
    bits = (hills / 12).astype(np.uint8)
    path = make_tif(tmp_path / "a.tif", bits)
    refused(path, "only 8 bits per cell, like a hillshade.*DEM_UNIT")
    assert np.array_equal(whole(open_dem(path, reading=DemReading(unit=12.0))), bits * np.float32(12))
    assert whole(open_dem(make_tif(tmp_path / "b.tif", bits, unit="m"))).max() == bits.max()
    assert whole(open_dem(make_tif(tmp_path / "c.tif", bits, scale=12.0, offset=0.0))).max() == int(bits.max()) * 12


@pytest.mark.parametrize("mode", ["hillshade", "slope", "aspect"])
def test_a_map_derived_from_heights_is_none(tmp_path, mode, shared_data):
    source = str(shared_data / "khumbu/dem/khumbu.tif")
    scale = {} if mode == "aspect" else {"scale": 111_120}
    gdal.DEMProcessing(str(tmp_path / "a.tif"), source, mode, **scale)
    gdal.Translate(str(tmp_path / "b.tif"), str(tmp_path / "a.tif"), outputType=gdal.GDT_Float32)
    refused(tmp_path / "b.tif", "like those of a hillshade, slope or aspect map")
    assert open_dem(tmp_path / "b.tif", reading=DemReading(unit="metres"))


@pytest.mark.parametrize("low_m, range_m", [(0.0, 40.0), (0.0, 90.0), (5.0, 250.0), (100.0, 5.0)])
def test_smooth_lowland_is_land(tmp_path, hills, low_m, range_m):
    land = low_m + (hills - hills.min()) / np.ptp(hills) * range_m
    assert open_dem(make_tif(tmp_path / "slope_of_the_dune.tif", land.astype(np.float32)))


def test_heights_in_decimetres_are_no_nodata(tmp_path, hills):
    path = make_tif(tmp_path / "a.tif", (hills * 20).astype(np.float32))
    refused(path, "no heights in metres: perhaps they are decimetres.*DEM_UNIT")
    read = whole(open_dem(path, reading=DemReading(unit="decimetres")))
    assert np.allclose(read, hills * 2, atol=0.01)


def test_untagged_fill_values_are_still_no_heights(tmp_path, hills):
    hills[:60] = 65_535
    hills[60:80] = 32_767
    values = whole(open_dem(make_tif(tmp_path / "a.tif", hills)))
    assert np.isnan(values[:80]).all()
    assert np.isfinite(values[80:]).all()


def test_nodata_that_the_user_sets_counts_and_the_file_s_may_be_switched_off(tmp_path, hills):
    hills[:5], hills[5:9] = 0, 77
    path = make_tif(tmp_path / "a.tif", hills, nodata=77)
    assert np.isnan(whole(open_dem(path))[5:9]).all()
    chosen = whole(open_dem(path, reading=DemReading(nodata_ranges=((-1.0, 1.0),))))
    assert np.isnan(chosen[:9]).all()
    assert np.isfinite(chosen[9:]).all()
    own = whole(open_dem(path, reading=DemReading(own_nodata=False)))
    assert (own[5:9] == 77).all()


def test_nodata_is_compared_in_the_unit_of_the_file(tmp_path, hills):
    feet = np.round(hills / 0.3048)
    value = float(feet[50, 50])
    read = whole(
        open_dem(make_tif(tmp_path / "a.tif", feet, unit="ft"), reading=DemReading(nodata_ranges=((value, value),)))
    )
    assert np.array_equal(np.isnan(read), feet == value)


def test_open_options_behind_the_path_are_open_options(tmp_path, hills):
    path = make_tif(tmp_path / "a.tif", hills)
    dem = open_dem(f"{path}|option:NUM_THREADS=2|option:GEOREF_SOURCES=INTERNAL")
    assert dem.path == path
    assert np.array_equal(whole(dem), hills)
    odd = make_tif(tmp_path / "b|option:C=D.tif", hills)
    assert open_dem(odd).path == odd


def test_a_plain_with_a_tower_is_a_dem(tmp_path):
    """One high cell carries all the variance, but most neighbours are equal, unlike those of a shaded map."""
    plain = np.zeros((301, 301), np.float32)
    plain[150, 150] = 255.0
    make_tif(tmp_path / "plain.tif", plain)
    assert whole(open_dem(tmp_path / "plain.tif")).max() == 255.0
