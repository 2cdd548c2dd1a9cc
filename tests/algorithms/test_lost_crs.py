"""Coordinate systems of which QGIS loses the definition when the thread that read them first ends."""

from __future__ import annotations

import itertools
import threading
import time
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
from skyline_viewshed.panel.model import drawing, photo_layer
from skyline_viewshed.panel.model.edits import NotEditableError

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
    while Path(f"/proc/self/task/{thread.native_id}").exists():  # the system ends it a moment later than Python
        time.sleep(0.001)


@pytest.fixture
def lost(qgis_app):
    """A system of its own that QGIS has lost, and its WKT."""
    # No other test has this place, so QGIS does not keep the system yet.
    text = f"+proj=aeqd +lat_0=46.5 +lon_0={next(PLACES) / 1000 + 8} +datum=WGS84 +units=m +no_defs"
    wkt = QgsCoordinateReferenceSystem.fromProj(text).toWkt(lost_crs.PREFERRED).replace("unknown", "of this test")
    with reading_thread(lambda: QgsCoordinateReferenceSystem.fromWkt(wkt)):
        crs = QgsCoordinateReferenceSystem.fromWkt(wkt)
        assert crs.isValid() and not lost_crs.is_lost(crs)
    assert lost_crs.is_lost(crs)  # a QGIS that fails here has mended it, and needs no `lost_crs`
    return crs, wkt


@pytest.fixture
def points(lost, scene):
    """The photographs of the scene as points of a layer whose system is lost."""
    layer = QgsVectorLayer("Point?crs=EPSG:4326&field=photo:string", "points", "memory")
    feature = QgsFeature(layer.fields())
    feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(0.0, 0.0)))
    feature.setAttributes([str(scene.folder / "north.jpg")])
    layer.dataProvider().addFeature(feature)
    layer.setCrs(lost[0])
    return layer


def test_a_system_is_made_again_from_its_definition(lost):
    _, wkt = lost
    crs = lost_crs.crs_of(f"WKT:{wkt}")
    assert crs.isValid() and crs.toProj().startswith("+proj=aeqd") and not lost_crs.is_lost(crs)


def test_neither_a_sound_system_nor_none_counts_as_lost(qgis_app):
    assert not lost_crs.is_lost(QgsCoordinateReferenceSystem("EPSG:32632"))
    assert not lost_crs.is_lost(QgsCoordinateReferenceSystem())


@pytest.mark.parametrize("code", ["EPSG:32632", ""])
def test_codes_and_the_lack_of_a_system_survive(qgis_app, code):
    crs = QgsCoordinateReferenceSystem(code)
    assert lost_crs.definition_of(crs) == code
    assert lost_crs.crs_of(code).authid() == code


def test_points_in_a_lost_system_get_a_sentence_instead_of_wrong_places(run, scene, points):
    with pytest.raises(QgsProcessingException, match="lost the definition"):
        run("orientphotos", {"INPUT": points, "DEM": str(scene.dem), "OUTPUT": "memory:"})
    assert "lost the definition" in photo_layer.layer_fault(points)


def test_nothing_is_drawn_into_a_layer_whose_system_is_lost(points):
    geometry, crs = QgsGeometry.fromPointXY(QgsPointXY(8.0, 46.5)), QgsCoordinateReferenceSystem("EPSG:4326")
    with pytest.raises(NotEditableError, match="lost the definition"):
        drawing.add_figure(points, "point", geometry, [], crs)
    assert points.featureCount() == 1 and not points.isEditable()


def test_what_another_thread_makes_keeps_the_system_that_the_user_gave_the_dem(scene):
    layer, made = QgsRasterLayer(str(scene.dem), "dem", "gdal"), []
    # No other test has this place, and QGIS keeps the text of its projection, not the WKT.
    text = f"+proj=aeqd +lat_0=46.5 +lon_0={next(PLACES) / 1000 + 8} +datum=WGS84 +units=m +no_defs"
    layer.setCrs(QgsCoordinateReferenceSystem.fromProj(text))
    definition = lost_crs.raster_definition(layer)
    with reading_thread(lambda: made.append(lost_crs.crs_of(definition))):
        pass
    assert made[0].isValid() and not lost_crs.is_lost(made[0])


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
