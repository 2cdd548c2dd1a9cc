"""Coordinate systems of which QGIS loses the definition when the thread that read them first ends."""

from __future__ import annotations

import itertools
import threading
from contextlib import contextmanager
from pathlib import Path

import pytest
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsFeature,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingException,
    QgsRasterLayer,
    QgsVectorLayer,
)
from skyline_viewshed.algorithms.shared import lost_crs

pytestmark = pytest.mark.qgis
PLACES = itertools.count(1)


@contextmanager
def reading_thread(read):
    """Call a function in a thread that lives until the end of the block."""
    begun, end = threading.Event(), threading.Event()
    kept = []

    def work():
        kept.append(read())
        begun.set()
        end.wait()

    thread = threading.Thread(target=work)
    thread.start()
    begun.wait()
    yield
    end.set()
    thread.join()


@pytest.fixture
def lost(qgis_app):
    """A system of its own, which QGIS has lost or, in newer versions, has not; and its WKT."""
    # No other test has this place, so QGIS does not keep the system yet.
    text = f"+proj=aeqd +lat_0=46.5 +lon_0={next(PLACES) / 1000 + 8} +datum=WGS84 +units=m +no_defs"
    wkt = QgsCoordinateReferenceSystem.fromProj(text).toWkt(lost_crs.PREFERRED).replace("unknown", "of this test")
    with reading_thread(lambda: QgsCoordinateReferenceSystem.fromWkt(wkt)):
        crs = QgsCoordinateReferenceSystem.fromWkt(wkt)
        assert crs.isValid() and not lost_crs.is_lost(crs)
    return crs, wkt


def test_a_system_is_made_again_from_its_definition(lost):
    _, wkt = lost
    crs = lost_crs.crs_of(f"WKT:{wkt}")
    assert crs.isValid() and crs.toProj().startswith("+proj=aeqd") and not lost_crs.is_lost(crs)


def test_a_lost_system_is_told_from_a_sound_one_and_from_none(lost):
    crs, _ = lost
    assert lost_crs.is_lost(crs) == (crs.toWkt() == "")
    assert not lost_crs.is_lost(QgsCoordinateReferenceSystem("EPSG:32632"))
    assert not lost_crs.is_lost(QgsCoordinateReferenceSystem())


@pytest.mark.parametrize("code", ["EPSG:32632", ""])
def test_codes_and_the_lack_of_a_system_survive(qgis_app, code):
    crs = QgsCoordinateReferenceSystem(code)
    assert lost_crs.definition_of(crs) == code
    assert lost_crs.crs_of(code).authid() == code


def test_points_in_a_lost_system_get_a_sentence_instead_of_wrong_places(run, lost):
    crs, _ = lost
    if not lost_crs.is_lost(crs):
        lost_crs.check_not_lost(crs)
        return
    layer = QgsVectorLayer("Point?crs=EPSG:4326", "points", "memory")
    feature = QgsFeature()
    feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(0.0, 0.0)))
    layer.dataProvider().addFeature(feature)
    layer.setCrs(crs)
    with pytest.raises(QgsProcessingException, match="lost the definition"):
        lost_crs.check_not_lost(layer.crs())


def test_a_dem_whose_layer_has_lost_its_system_still_gives_its_results_one(run, scene, tmp_path):
    from osgeo import gdal

    # A VRT spells the system in another way than the scene's GeoTIFF, which QGIS may keep already.
    path = str(tmp_path / "dem.vrt")
    gdal.Translate(path, str(scene.dem), format="VRT")
    QgsCoordinateReferenceSystem.invalidateCache()
    with reading_thread(lambda: QgsRasterLayer(path, "first", "gdal").crs()):
        layer = QgsRasterLayer(path, "dem", "gdal")
    folder = tmp_path / "photos"
    folder.mkdir()
    (folder / "north.jpg").write_bytes((Path(scene.folder) / "north.jpg").read_bytes())
    given = {"FOLDER": str(folder), "DEM": layer, "MAX_DISTANCE": 5000, "OUTPUT": "memory:", "POLYGONS": "memory:"}
    given["VIEWSHED"] = str(tmp_path / "seen.tif")
    results, _ = run("photoviewshed", given)
    assert results["POLYGONS"].crs().toProj().startswith("+proj=aeqd")
    assert results["POLYGONS"].featureCount() == 1
