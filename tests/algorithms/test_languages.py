"""A run in a German, French or Spanish QGIS: what it writes for people is in that language."""

from __future__ import annotations

import re
import string
from pathlib import Path

import pytest
from osgeo import gdal
from qgis.core import (
    QgsApplication,
    QgsFeature,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingContext,
    QgsProject,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QCoreApplication, QTranslator
from skyline_viewshed.tools import make_translations

ROOT = Path(__file__).resolve().parent.parent.parent
ENGLISH = ("The", "the", "and", "heading", "Heading", "photograph", "horizon", "picture", "accepted", "numbers", "with")
"""Words that no report in another language has, where the photographs' own texts have none."""


@pytest.fixture
def speaking(compiled, qgis_app):
    """Install a language for the length of a test: call it with 'de', 'fr' or 'es'."""
    installed = []

    def speak(language):
        translator = QTranslator()
        assert translator.load(str(compiled[language]))
        QCoreApplication.installTranslator(translator)
        installed.append(translator)
        return make_translations.read_catalogue(make_translations.catalogue_path(language))

    yield speak
    for translator in installed:
        QCoreApplication.removeTranslator(translator)


def words_of(report):
    """Words of a page outside style and script."""
    text = re.sub(r"<(style|script)>.*?</\1>", " ", report.read_text(encoding="utf-8"), flags=re.DOTALL)
    text = re.sub(r'"data:image/[^"]*"', "", text)
    spoken = re.findall(r' (?:alt|aria-label|title)="([^"]*)"', text)
    return " ".join([*spoken, re.sub(r"<[^>]*>", " ", text)])


@pytest.mark.parametrize("language", make_translations.LANGUAGES)
def test_a_run_speaks_the_language(speaking, run, scene, tmp_path, language):
    catalogue = speaking(language)
    outputs = {"OUTPUT": "memory:", "POLYGONS": "memory:", "VIEWSHED": str(tmp_path / "v.tif")}
    parameters = {"FOLDER": str(scene.folder), "DEM": str(scene.dem), "MAX_DISTANCE": 5000, **outputs}
    _, feedback = run("photoviewshed", {**parameters, "REPORT": str(tmp_path / "report.html")})
    said = words_of(tmp_path / "report.html")
    for word in ("Heading", "Parameters, DEM and software", "Camera heading and visible ground", "Run", "Lens"):
        assert catalogue[word].replace("'", "&#x27;") in said, word
    assert f'<html lang="{language}">' in (tmp_path / "report.html").read_text(encoding="utf-8")
    leftovers = set(said.translate(str.maketrans("", "", string.punctuation)).split()) & set(ENGLISH)
    assert leftovers - {"horizon", "Horizon"} == set()
    assert catalogue["accepted"] in " ".join(feedback.infos)
    dataset = gdal.Open(str(tmp_path / "v.tif"))
    assert dataset.GetRasterBand(1).GetDescription() == catalogue["photographs that see the cell"]


def test_attributes_keep_their_english_values(speaking, run, scene, tmp_path):
    """`status` is a contract: styles, models and scripts compare it."""
    speaking("de")
    results, _ = run(
        "orientphotos", {"INPUT": photos(run, scene, tmp_path), "DEM": str(scene.dem), "OUTPUT": "memory:"}
    )
    assert {f["status"] for f in results["OUTPUT"].getFeatures()} <= {"accepted", "ambiguous", "rejected", "failed"}


def photos(run, scene, tmp_path):
    path = str(tmp_path / "photos.gpkg")
    run("importphotos", {"FOLDER": str(scene.folder), "OUTPUT": path})
    return path


def filled(template, **facts):
    """Pattern of a translated template whose other facts are numbers."""
    return re.sub(r"\\{(\w+)\\}", lambda name: facts.get(name[1], r"[\d.]+"), re.escape(template))


def test_what_the_core_says_is_in_the_language_even_if_an_english_run_has_kept_it(speaking, run, scene, tmp_path):
    """An error with its reason, a verdict and a note; all three as attributes, in the log and in the report."""
    layer = QgsVectorLayer("Point?crs=EPSG:4326&field=photo:string", "points", "memory")
    for path in (scene.odd / "null_island.jpg", scene.odd / "damaged.jpg"):
        feature = QgsFeature(layer.fields())
        feature.setAttributes([str(path)])
        feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(*scene.positions["west"])))
        layer.dataProvider().addFeatures([feature])
    given = {"INPUT": layer, "DEM": str(scene.dem), "OUTPUT": "memory:", "ORIENTATIONS": str(tmp_path / "kept")}
    results, _ = run("orientphotos", given)
    assert "no other heading scores close" in next(results["OUTPUT"].getFeatures())["message"]
    catalogue = speaking("de")
    results, feedback = run("orientphotos", {**given, "REPORT": str(tmp_path / "report.html")})
    taken = filled(catalogue["{name}: taken from {path}"], name="null_island.jpg", path=".*")
    assert any(re.fullmatch(taken, info) for info in feedback.infos)
    answered, failed = (feature["message"] for feature in results["OUTPUT"].getFeatures())
    verdict = catalogue[
        "The DEM horizon matches the skyline in {share} % of the columns; no other heading scores close."
    ]
    note = catalogue["The recorded coordinates are 0, 0 (no GPS fix) and were ignored."]
    assert re.fullmatch(f"{filled(verdict)} {re.escape(note)}", answered)
    reason = catalogue["it is damaged or incomplete. Copy it again from its source."]
    path = str(scene.odd / "damaged.jpg")
    assert failed == catalogue["The photo {path} cannot be read: {reason}"].format(path=path, reason=reason)
    assert f"damaged.jpg: {failed}" in feedback.warnings
    said = words_of(tmp_path / "report.html")
    assert note in said and reason in said and re.search(filled(verdict), said)


def test_a_refused_dem_is_refused_in_the_language(speaking, refusal, scene, tmp_path):
    path = str(tmp_path / "rotated.tif")
    gdal.Translate(path, str(scene.dem))
    rotated = gdal.Open(path, gdal.GA_Update)
    rotated.SetGeoTransform((0, 20, 5, 0, 5, -20))
    del rotated
    catalogue = speaking("de")
    sentence = catalogue["The DEM {path} is rotated relative to its CRS. Warp it to a north-up grid first (gdalwarp)."]
    outputs = {"OUTPUT": "memory:", "POLYGONS": "memory:", "VIEWSHED": str(tmp_path / "v.tif")}
    said = refusal("photoviewshed", {"FOLDER": str(scene.folder), "DEM": path, **outputs})
    assert said == sentence.format(path=path)


def test_a_horizon_report_speaks_the_language(speaking, run, scene, tmp_path):
    catalogue = speaking("es")
    points = photos(run, scene, tmp_path)
    report = tmp_path / "horizon.html"
    parameters = {"INPUT": points, "DEM": str(scene.dem), "AZIMUTH_STEP": 5, "OUTPUT": "memory:", "REPORT": str(report)}
    run("horizonprofile", parameters)
    said = words_of(report)
    for word in ("Highest horizon", "Place and horizon", "Elevation angle", "Sky view factor"):
        assert catalogue[word] in said, word


def test_models_speak_the_language(speaking, provider):
    catalogue = speaking("fr")
    registry = QgsApplication.processingRegistry()
    for name in ("geotaggedphotos", "compassviewsheds", "viewshedlandcover"):
        model = registry.algorithmById(f"skylineviewshed:{name}").create()
        labels = [definition.description() for definition in model.parameterDefinitions()]
        labels += [output.description() for output in model.outputDefinitions()]
        spoken = set(catalogue.values())
        assert len(labels) > 4 and not [label for label in labels if label not in spoken]
        assert catalogue["Ground in view"] in labels or name == "viewshedlandcover"
        assert model.helpContent()["ALG_DESC"] in spoken


def test_every_text_of_the_models_is_in_the_catalogue(provider):
    from skyline_viewshed.processing_provider.models import TEXTS

    for path in sorted((ROOT / "models").glob("*.model3")):
        model = QgsApplication.processingRegistry().algorithmById(f"skylineviewshed:{path.stem}").create()
        texts = [definition.description() for definition in model.parameterDefinitions()]
        texts += [output.description() for output in model.outputDefinitions()]
        texts.append(model.helpContent()["ALG_DESC"])
        assert set(texts) <= set(TEXTS), path.name


def test_every_legend_is_in_the_catalogue():
    from skyline_viewshed.algorithms.shared.legends import ENTRIES

    found = set()
    for path in sorted((ROOT / "styles").glob("*.qml")):
        found |= set(re.findall(r'<(?:category|item) [^>]*label="([^"]+)"', path.read_text(encoding="utf-8")))
    with_letters = {label for label in found if re.search("[a-z]{3}", label)}
    assert with_letters == set(ENTRIES)


def test_every_tab_of_the_forms_is_in_the_catalogue():
    from skyline_viewshed.algorithms.shared.legends import TABS

    text = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "styles").glob("*.qml"))
    assert set(re.findall(r'<attributeEditorContainer [^>]*name="([^"]+)"', text)) == set(TABS)


def test_a_layer_s_legend_speaks_the_language(speaking, run, scene, tmp_path):
    from skyline_viewshed.algorithms.shared.styling import style_on_completion

    catalogue = speaking("de")
    points = photos(run, scene, tmp_path)
    context = QgsProcessingContext()
    details = QgsProcessingContext.LayerDetails("photos", QgsProject.instance(), "OUTPUT")
    context.addLayerToLoadOnCompletion(points, details)
    style_on_completion(context, points, "oriented", "photos")
    layer = QgsVectorLayer(points, "photos")
    context.layerToLoadOnCompletionDetails(points).postProcessor().postProcessLayer(layer, context, None)
    labels = [category.label() for category in layer.renderer().categories()]
    assert labels == [catalogue[label] for label in (
        "accepted: trust it", "confirmed by a person", "ambiguous: look at the report", "rejected: no answer",
        "failed: input at fault",
    )]  # fmt: skip


def test_a_raster_s_legend_speaks_the_language(speaking, scene):
    from qgis.core import QgsRasterLayer
    from skyline_viewshed.algorithms.shared.legends import translate_legend
    from skyline_viewshed.algorithms.shared.styling import STYLES

    catalogue = speaking("es")
    layer = QgsRasterLayer(str(scene.dem), "viewshed")
    layer.loadNamedStyle(str(STYLES / "viewshed.qml"))
    translate_legend(layer)
    labels = [item.label for item in layer.renderer().shader().rasterShaderFunction().colorRampItemList()]
    assert labels[:2] == [catalogue["not seen"], catalogue["1 photo"]]


def test_a_style_beside_a_file_speaks_the_language(speaking, tmp_path):
    from xml.etree import ElementTree

    from skyline_viewshed.algorithms.shared.styling import dress_file

    catalogue = speaking("fr")
    dress_file(str(tmp_path / "a.tif"), "layers")
    labels = [item.get("label") for item in ElementTree.parse(tmp_path / "a.qml").getroot().iter("item")]
    assert labels[3:5] == [catalogue["just hidden"], catalogue["just seen"]] and labels[3] != "just hidden"
