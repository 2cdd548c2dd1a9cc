"""GDAL's messages are kept, whatever is in them."""

from __future__ import annotations

import numpy as np
import pytest
from skyline_viewshed.core.io.gdal_quiet import open_quietly, quiet_gdal
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.demo.dem_file import write_dem

gdal = pytest.importorskip("osgeo.gdal")


@pytest.fixture(params=[False, True], ids=["codes", "exceptions"])
def raising(request):
    """GDAL as a host may have set it: telling of failures by codes, or by exceptions."""
    before = gdal.GetUseExceptions()
    (gdal.UseExceptions if request.param else gdal.DontUseExceptions)()
    yield request.param
    (gdal.UseExceptions if before else gdal.DontUseExceptions)()


@pytest.fixture
def telling():
    """GDAL that tells of failures by codes."""
    before = gdal.GetUseExceptions()
    gdal.DontUseExceptions()
    yield
    if before:
        gdal.UseExceptions()


def test_failures_are_collected_and_warnings_on_request(telling):
    for warnings, expected in ((False, ["two"]), (True, ["one", "two"])):
        with quiet_gdal(warnings) as messages:
            gdal.Error(gdal.CE_Warning, 1, " one\n")
            gdal.Error(gdal.CE_Failure, 1, "two")
        assert messages == expected


@pytest.fixture
def dem_with_a_message_that_is_no_text(tmp_path):
    """A DEM of whose damaged metadata GDAL complains by quoting them; found by fuzzing."""
    path = tmp_path / "dem.tif"
    write_dem(str(path), np.full((40, 48), 1200.0), 90.0, 8.0, 46.0)
    content = path.read_bytes()
    assert content.count(b"<Item") == 1
    path.write_bytes(content.replace(b"<Item", b"<\xb1te\xff").replace(b"</Item>", b"       "))
    return path


def test_a_message_that_is_no_utf8_is_not_an_error_of_python(dem_with_a_message_that_is_no_text, raising):
    for _ in range(3):
        with quiet_gdal() as messages:
            dataset = gdal.OpenEx(str(dem_with_a_message_that_is_no_text))
        assert dataset is not None and all(isinstance(text, str) for text in messages)
        assert messages or raising, "what fails is told, in one way or the other"
    assert open_quietly(dem_with_a_message_that_is_no_text) is not None


def test_a_dem_with_such_a_message_still_has_its_cells(dem_with_a_message_that_is_no_text, raising):
    assert open_dem(str(dem_with_a_message_that_is_no_text)).shape == (40, 48)
