"""The table of lenses: from a CSV file or layer to k1 and k2 of the photographs, and sentences about faulty tables."""

from dataclasses import replace

import pytest
from osgeo import ogr
from qgis.core import (
    NULL,
    QgsFeature,
    QgsGeometry,
    QgsPointXY,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingModelAlgorithm,
    QgsProcessingModelChildAlgorithm,
    QgsProcessingModelChildParameterSource,
    QgsProcessingModelOutput,
    QgsProcessingModelParameter,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterRasterLayer,
    QgsVectorLayer,
)
from skyline_viewshed.core.base.angles import difference
from skyline_viewshed.core.base.camera import Camera, Pose, focal_of_fov_px
from skyline_viewshed.core.base.model import PhotoMetadata
from skyline_viewshed.core.base.terrain import Observer
from skyline_viewshed.core.io.raster import open_dem
from skyline_viewshed.core.io.write_photo import write_photo
from skyline_viewshed.core.simulate.render import render_view
from skyline_viewshed.core.simulate.scene import SceneOptions

K1 = -0.12
POSE = Pose(20.0, 2.0, 0.5)
LENSES = f"make,model,focal,k1,k2\nAcme,Wide 3,3.0,{K1},0\nAcme,,,0.01,0\nOther,,,0.2,0\n"


@pytest.fixture(scope="module")
def photos(scene, tmp_path_factory):
    """Folder with one view through three cameras: one in the table, one of the same maker, one unknown."""
    folder, place = tmp_path_factory.mktemp("lenses"), scene.positions["north"]
    camera = Camera(800, 600, focal_of_fov_px(800, 75.0), k1=K1)
    view = render_view(open_dem(str(scene.dem)), Observer(*place, 2.0), camera, POSE, SceneOptions(0))
    known = PhotoMetadata("", 800, 600, *place[::-1], focal_length_mm=3.0, focal_length_35mm=22.6)
    for name, maker in (("known", "Acme Wide 3"), ("kin", "Acme Zoom"), ("strange", "Nobody One")):
        write_photo(str(folder / f"{name}.jpg"), view.pixels, replace(known, camera=maker))
    return folder


@pytest.fixture
def table(tmp_path):
    def write(text=LENSES):
        path = tmp_path / "lenses.csv"
        path.write_text(text, encoding="utf-8")
        return str(path)

    return write


def points_of(folder, place, *rows):
    """Layer of photographs (name, k1)."""
    layer = QgsVectorLayer("Point?crs=EPSG:4326&field=photo:string&field=k1:double&field=hfov:double", "p", "memory")
    for name, k1 in rows:
        feature = QgsFeature(layer.fields())
        feature.setGeometry(QgsGeometry.fromPointXY(QgsPointXY(*place)))
        feature.setAttributes([str(folder / f"{name}.jpg"), k1, 75.0])
        layer.dataProvider().addFeature(feature)
    return layer


def test_the_table_gives_k1_and_k2_but_the_points_own_values_win(run, scene, photos, table):
    layer = points_of(
        photos, scene.positions["north"], ("known", NULL), ("known", 0.05), ("kin", NULL), ("strange", NULL)
    )
    given = {"INPUT": layer, "DEM": str(scene.dem), "HFOV_FIELD": "hfov", "OUTPUT": "memory:"}
    results, told = run("orientphotos", {**given, "LENS_TABLE": table()})
    rows = list(results["OUTPUT"].getFeatures())
    assert [(row["k1"], row["k2"]) for row in rows] == [(K1, 0.0), (0.05, 0.0), (0.01, 0.0), (NULL, NULL)]
    assert rows[0]["status"] == "accepted" and abs(difference(rows[0]["heading"], POSE.heading_deg)) < 0.3
    assert rows[0]["ncc"] > max(row["ncc"] for row in rows[1:])
    assert any("2 of 4 photos take k1 and k2" in text for text in told.infos)
    (warning,) = [text for text in told.warnings if "table of lenses" in text]
    assert "strange.jpg (Nobody One, 3 mm)" in warning and "known.jpg" not in warning


def test_a_folder_takes_them_and_later_steps_find_them(qgis_process, scene, photos, table, tmp_path):
    done = qgis_process(
        "run",
        "skylineviewshed:photoviewshed",
        "--",
        f"FOLDER={photos}",
        f"DEM={scene.dem}",
        f"LENS_TABLE={table()}",
        "MAX_DISTANCE=2000",
        "HFOV=75",
        *(f"{name}={tmp_path / file}" for name, file in (("OUTPUT", "o.gpkg"), ("POLYGONS", "g.gpkg"))),
        f"VIEWSHED={tmp_path / 'v.tif'}",
        f"REPORT={tmp_path / 'r.html'}",
    )
    assert done.returncode == 0, done.stderr
    said = done.stdout + done.stderr  # where warnings go depends on the version
    assert "2 of 3 photos take k1 and k2" in said and "strange.jpg (Nobody One, 3 mm)" in said
    source = ogr.Open(str(tmp_path / "o.gpkg"))
    found = {row["filename"]: (row["k1"], row["k2"]) for row in source.GetLayer(0)}
    assert found == {"known": (K1, 0.0), "kin": (0.01, 0.0), "strange": (None, None)}
    assert f"{K1:.4f}" in (tmp_path / "r.html").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("make,k2\nAcme,1\n", "needs the fields k1 and k2"),
        ("camera,k1\nAcme,0.1\n", "it has camera, k1"),
        ("make,k1\n", "has no row"),
        ('make,k1\nAcme,"-0,12"\n', "Row 1 of LENS_TABLE: k1 is -0,12"),
        ("make,focal,k1\nAcme,18-55,0.1\n", "Row 1 of LENS_TABLE: focal is 18-55"),
        ("make,focal,k1\nAcme,0,0.1\n", "focal is 0"),
        ("make,k1\nAcme,0.1\nOther,\n", "Row 2 of LENS_TABLE has no k1"),
        ('make,k1\n"",0.1\n', "Row 1 of LENS_TABLE names no camera"),
        ("make,k1\nAcme,0.1\nacme,0.2\n", "Rows 1 and 2 of LENS_TABLE give one lens different distortions"),
    ],
)
@pytest.mark.parametrize("name", ["orientphotos", "photoviewshed"])
def test_a_faulty_table_is_refused_before_the_first_photo(refusal, scene, photos, table, name, text, sentence):
    layer = points_of(photos, scene.positions["north"], ("known", NULL))
    given = {"INPUT": layer, "DEM": str(scene.dem), "LENS_TABLE": table(text)}
    outputs = {"OUTPUT": "memory:", "POLYGONS": "memory:", "VIEWSHED": "TEMPORARY_OUTPUT"}
    assert sentence in refusal(name, {**given, **outputs})


def test_rows_that_fit_equally_well_are_told_before_the_first_photo(run, scene, photos, table):
    layer = points_of(photos, scene.positions["north"], ("known", NULL))
    unclear = table("make,model,k1\nAcme,,0.1\n,Wide 3,0.2\n")
    given = {"INPUT": layer, "DEM": str(scene.dem), "LENS_TABLE": unclear, "OUTPUT": "memory:"}
    with pytest.raises(Exception, match="Rows 1 and 2 of LENS_TABLE fit known.jpg equally well"):
        run("orientphotos", given)


def test_the_table_is_an_input_of_a_model(provider, scene, photos, table):
    model, child = QgsProcessingModelAlgorithm("lenses", "tests"), QgsProcessingModelChildAlgorithm()
    inputs = {
        "INPUT": QgsProcessingParameterFeatureSource("points"),
        "DEM": QgsProcessingParameterRasterLayer("dem"),
        "LENS_TABLE": QgsProcessingParameterFeatureSource("table", "", [5], optional=True),
    }
    child.setChildId("orient")
    child.setAlgorithmId("skylineviewshed:orientphotos")
    sources = QgsProcessingModelChildParameterSource
    for name, parameter in inputs.items():
        model.addModelParameter(parameter, QgsProcessingModelParameter(parameter.name()))
        child.addParameterSources(name, [sources.fromModelParameter(parameter.name())])
    for name, value in (("HFOV_FIELD", "hfov"), ("METHOD", 0), ("COMPASS", 0)):
        child.addParameterSources(name, [sources.fromStaticValue(value)])
    output = QgsProcessingModelOutput("found", "")
    output.setChildOutputName("OUTPUT")
    child.setModelOutputs({"found": output})
    model.addChildAlgorithm(child)
    assert model.validate()[0], model.validate()[1]
    context = QgsProcessingContext()
    given = {"points": points_of(photos, scene.positions["north"], ("known", NULL)), "dem": str(scene.dem)}
    given.update(table=table(), **{"orient:found": "memory:"})
    results, done = model.run(given, context, QgsProcessingFeedback())
    assert done
    (row,) = context.getMapLayer(results["orient:found"]).getFeatures()
    assert (row["k1"], row["k2"]) == (K1, 0.0)
