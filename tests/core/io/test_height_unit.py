"""Units of a DEM's heights, in the spellings and places in which formats write them."""

import pytest
from osgeo import gdal, osr
from skyline_viewshed.core.base.errors import UnusableDemError
from skyline_viewshed.core.io.height_unit import metres_per_unit

FOOT, SURVEY_FOOT = 0.3048, 1200 / 3937


def unit_of(unit="", crs="EPSG:32632", chosen=None, own=None):
    dataset = gdal.GetDriverByName("MEM").Create("", 3, 3)
    reference = osr.SpatialReference()
    reference.SetFromUserInput(own or crs)
    dataset.SetSpatialRef(reference)
    dataset.GetRasterBand(1).SetUnitType(unit)
    wanted = osr.SpatialReference()
    wanted.SetFromUserInput(crs)
    return metres_per_unit(dataset, dataset.GetRasterBand(1), wanted.ExportToWkt(), chosen)


@pytest.mark.parametrize(
    "spelling, metres",
    [
        *((text, 1.0) for text in ("", "m", "Metre", "meters", "[m]", "metre (EGM96)", "m above sea level", "none")),
        *((text, FOOT) for text in ("ft", "FEET", "foot", "[ft_i]", "International foot", "feet (NAVD88)")),
        *((text, SURVEY_FOOT) for text in ("US survey foot", "us_survey_foot", "US-ft", "ftUS", "Foot_US", "[ft_us]",
                                           "U.S. Survey Feet", "us_survey_feet")),
        ("dm", 0.1), ("Decimetre", 0.1), ("cm", 0.01), ("km", 1000.0), ("yard", 0.9144), ("fathom", 1.8288),
        ("British foot (Sears 1922)", 0.3047994715), ("Clarke's foot", 0.3047972654),
    ],
)  # fmt: skip
def test_spellings(spelling, metres):
    assert unit_of(spelling) == pytest.approx(metres, rel=1e-8)


@pytest.mark.parametrize("spelling", ["degree", "percent", "m**2 s**-2", "radians", "K", "furlong"])
def test_what_is_no_known_height_is_refused(spelling):
    with pytest.raises(UnusableDemError, match="not a unit of height.*DEM_UNIT"):
        unit_of(spelling)
    assert unit_of(spelling, chosen="feet") == FOOT


@pytest.mark.parametrize(
    "crs, metres",
    [("EPSG:2263+6360", SURVEY_FOOT), ("EPSG:26910+8228", FOOT), ("EPSG:32632+5773", 1.0), ("EPSG:4979", 1.0),
     ("EPSG:4326", 1.0), ("EPSG:2263", 1.0)],
)  # fmt: skip
def test_the_vertical_axis_counts_and_the_horizontal_one_does_not(crs, metres):
    assert unit_of(crs=crs) == pytest.approx(metres, rel=1e-8)


def test_the_band_precedes_the_crs_and_the_user_both():
    assert unit_of("m", "EPSG:2263+6360") == 1.0
    assert unit_of("m", "EPSG:2263+6360", "decimetres") == 0.1
    assert unit_of("m", chosen=0.25) == 0.25
    assert unit_of("m", chosen="0.25") == 0.25


def test_another_crs_assigned_to_the_file_leaves_its_heights_in_feet():
    assert unit_of(crs="EPSG:32618", own="EPSG:2263+6360") == pytest.approx(SURVEY_FOOT)


@pytest.mark.parametrize("chosen", ["furlongs", "0", "-1", "nan", ""])
def test_a_wrong_choice_is_told(chosen):
    with pytest.raises(UnusableDemError, match="is not known. Give metres"):
        unit_of(chosen=chosen)


@pytest.mark.parametrize("words, metres", [("FEET", FOOT), ("NO", 1.0), ("METERS", 1.0), ("100", 0.01)])
def test_an_old_esri_sidecar_counts(tmp_path, words, metres):
    grid = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 10\n1 2\n3 4\n"
    (tmp_path / "a.asc").write_text(grid)
    (tmp_path / "a.prj").write_text(f"Projection UTM\nZone 32\nDatum WGS84\nZunits {words}\nUnits METERS\nParameters\n")
    dataset = gdal.Open(str(tmp_path / "a.asc"))
    assert metres_per_unit(dataset, dataset.GetRasterBand(1), "EPSG:32632") == pytest.approx(metres)
