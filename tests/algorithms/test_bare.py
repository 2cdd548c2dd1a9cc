"""What QGIS ships is enough: without OpenCV, pillow-heif and exifread everything loads and JPEGs give the same."""

import subprocess
import sys

import pytest
from qgis.core import QgsFeature, QgsGeometry, QgsPointXY, QgsVectorLayer

SCRIPT = """
import sys
for module in ("cv2", "pillow_heif", "exifread"):
    sys.modules[module] = None
from qgis.core import QgsApplication
application = QgsApplication([], True)
application.initQgis()
sys.path.insert(0, QgsApplication.pkgDataPath() + "/python/plugins")
from processing.core.Processing import Processing
Processing.initialize()
import processing
from skyline_viewshed import classFactory
plugin = classFactory(None)
plugin.initProcessing()
print("ALGORITHMS", len(plugin.provider.algorithms()))
photos = processing.run("skylineviewshed:importphotos", {"FOLDER": sys.argv[1], "OUTPUT": "memory:"})["OUTPUT"]
results = processing.run("skylineviewshed:orientphotos", {"INPUT": photos, "DEM": sys.argv[2], "OUTPUT": "memory:"})
for feature in results["OUTPUT"].getFeatures():
    print("FOUND", feature["filename"], feature["status"], feature["heading"], feature["pitch"])
"""


@pytest.fixture(scope="module")
def told(scene):
    done = subprocess.run(
        [sys.executable, "-c", SCRIPT, str(scene.folder), str(scene.dem)],
        capture_output=True,
        text=True,
        stdin=subprocess.DEVNULL,
        timeout=300,
    )
    # QGIS may end a script's process with a signal after all is done; what it printed before counts.
    return [line.split() for line in done.stdout.splitlines()], done.stderr


def test_everything_loads(told):
    lines, errors = told
    counts = [int(line[1]) for line in lines if line and line[0] == "ALGORITHMS"]
    assert counts and counts[0] >= 11, errors


def test_jpeg_photos_come_out_as_with_the_packages(told, scene, run):
    photos, _ = run("importphotos", {"FOLDER": str(scene.folder), "OUTPUT": "memory:"})
    full, _ = run("orientphotos", {"INPUT": photos["OUTPUT"], "DEM": str(scene.dem), "OUTPUT": "memory:"})
    full = {f["filename"]: f for f in full["OUTPUT"].getFeatures()}
    bare = {line[1]: line[2:] for line in told[0] if line and line[0] == "FOUND"}
    assert set(bare) == set(full) == {"north", "west"}
    for name, (status, heading, pitch) in bare.items():
        assert status == full[name]["status"]
        assert float(heading) == pytest.approx(full[name]["heading"], abs=0.1)
        assert float(pitch) == pytest.approx(full[name]["pitch"], abs=0.1)


@pytest.mark.data
def test_heic_without_any_decoder_says_what_to_install(run, scene, shared_data, monkeypatch):
    from osgeo import gdal
    from skyline_viewshed.core.io import pixels

    driver = gdal.GetDriverByName("HEIF")
    real = pixels.available
    monkeypatch.setattr(pixels, "available", lambda module: None if module == "pillow_heif" else real(module))
    layer = QgsVectorLayer("Point?crs=EPSG:4326&field=photo:string", "photo", "memory")
    feature = QgsFeature(layer.fields())
    feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(*scene.positions["west"])))
    feature.setAttributes([str(shared_data / "khumbu" / "photos" / "IMG_2195.HEIC")])
    layer.dataProvider().addFeature(feature)
    if driver is not None:
        driver.Deregister()
    try:
        results, feedback = run("orientphotos", {"INPUT": layer, "DEM": str(scene.dem), "OUTPUT": "memory:"})
    finally:
        if driver is not None:
            driver.Register()
    found = next(results["OUTPUT"].getFeatures())
    assert found["status"] == "failed" and "pillow-heif" in found["message"]
    assert any("pillow-heif" in warning for warning in feedback.warnings)
