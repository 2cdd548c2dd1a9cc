"""A run where names are odd: spaces, umlauts, an emoji, 200 characters, words that look like HTML."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from whole_runs import arguments, outputs_in, rows_of

pytestmark = pytest.mark.qgis

HOSTILE = 'it\'s <img src=x onerror=alert(1)> & "100 %" 🏔 Säntis.jpg'


@pytest.fixture(scope="module")
def odd_run(qgis_process, scene, tmp_path_factory):
    """One run in a folder of spaces, umlauts, an emoji and more than 200 characters, with the DEM as a VRT in it."""
    from osgeo import gdal

    folder = tmp_path_factory.mktemp("odd") / "Fotos für Zoë 🏔" / ("lang" * 45) / "50% & more"
    photos, results = folder / "Bilder", folder / "out put"
    photos.mkdir(parents=True)
    assert len(str(photos)) > 200
    shutil.copy(scene.folder / "north.jpg", photos / HOSTILE)
    dem = folder / "Höhen modell.vrt"
    assert gdal.BuildVRT(str(dem), [str(scene.dem)]) is not None
    outputs = outputs_in(results)
    return outputs, photos, qgis_process(*arguments(photos, dem, outputs))


def test_odd_paths_and_a_vrt_work(odd_run, scene):
    outputs, photos, done = odd_run
    assert done.returncode == 0, done.stderr
    (row,) = rows_of(outputs["OUTPUT"])
    assert row["photo"] == str(photos / HOSTILE)
    assert row["heading"] == pytest.approx(scene.truth["north"].heading_deg, abs=0.5)
    assert len(list(outputs["RASTERS"].glob("*.tif"))) == 1 and outputs["VIEWSHED"].exists()
    assert [path.stem for path in outputs["ORIENTATIONS"].iterdir()] == [Path(HOSTILE).stem]


def test_a_hostile_file_name_stays_text_in_the_report(odd_run):
    report = odd_run[0]["REPORT"].read_text(encoding="utf-8")
    assert "<img src=x" not in report and "&lt;img src=x onerror=alert(1)&gt;" in report
