from __future__ import annotations

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.base.errors import UnreadableFeaturesError
from skyline_viewshed.core.base.pixel_features import PixelFeature, downward
from skyline_viewshed.core.io import features


def read_features(path):
    return features.read_features(path)[0]


@pytest.fixture
def saved(tmp_path):
    def save(content, name="features.json"):
        path = tmp_path / name
        path.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")
        return str(path)

    return save


def test_labelme_shapes_are_shifted_from_the_corner_to_the_pixels_centre(saved):
    shapes = [
        {"label": "glacier", "points": [[10.5, 20.5], [30, 20], [30, 40]], "shape_type": "polygon"},
        {"label": "summit", "points": [[100, 50]], "shape_type": "point"},
        {"label": "trail", "points": [[0, 0], [5, 5], [9, 2]], "shape_type": "linestrip"},
        {"label": "hut", "points": [[8, 9], [2, 3]], "shape_type": "rectangle"},
        {"label": "lake", "points": [[50, 50], [50, 60]], "shape_type": "circle"},
    ]
    found = read_features(saved({"version": "5.4", "shapes": shapes, "imagePath": "..\\photos\\IMG_1.jpg"}))
    assert [f.kind for f in found] == ["polygon", "point", "line", "polygon", "polygon"]
    assert [f.label for f in found] == ["glacier", "summit", "trail", "hut", "lake"]
    assert found[0].parts[0].tolist() == [[10, 20], [29.5, 19.5], [29.5, 39.5]]
    assert found[3].parts[0].tolist() == [[1.5, 2.5], [7.5, 2.5], [7.5, 8.5], [1.5, 8.5]]
    assert np.hypot(*(found[4].parts[0] - 49.5).T) == pytest.approx(10)
    assert {f.photo for f in found} == {"..\\photos\\IMG_1.jpg"}


def test_coco_segmentations_boxes_and_keypoints(saved):
    data = {
        "images": [{"id": 7, "file_name": "a/IMG_1.jpg"}],
        "categories": [{"id": 2, "name": "ice"}],
        "annotations": [
            {"image_id": 7, "category_id": 2, "segmentation": [[0.5, 0.5, 10.5, 0.5, 10.5, 10.5], [1, 1, 2, 1, 2, 2]]},
            {"image_id": 7, "category_id": 2, "bbox": [10.5, 20.5, 4, 2], "segmentation": []},
            {"image_id": 7, "category_id": 2, "keypoints": [1.5, 2.5, 2, 0, 0, 0]},
        ],
    }
    found = read_features(saved(data))
    assert [f.kind for f in found] == ["polygon", "polygon", "polygon", "point"]
    assert found[0].parts[0].tolist() == [[0, 0], [10, 0], [10, 10]]
    assert found[2].parts[0].tolist() == [[10, 20], [14, 20], [14, 22], [10, 22]]
    assert found[3].parts[0].tolist() == [[1, 2]]
    assert {f.label for f in found} == {"ice"} and {f.photo for f in found} == {"a/IMG_1.jpg"}


VIA_REGION = {
    "shape_attributes": {"name": "polyline", "all_points_x": [1, 3, 5], "all_points_y": [2, 4, 2]},
    "region_attributes": {"class": "moraine"},
}


@pytest.mark.parametrize("wrapped", [True, False])
def test_via_projects_and_annotations(saved, wrapped):
    pictures = {"IMG_1.jpg123": {"filename": "IMG_1.jpg", "size": 123, "regions": [VIA_REGION]}}
    (found,) = read_features(saved({"_via_img_metadata": pictures} if wrapped else pictures))
    assert (found.kind, found.label, found.photo) == ("line", "moraine", "IMG_1.jpg")
    assert found.parts[0].tolist() == [[0.5, 1.5], [2.5, 3.5], [4.5, 1.5]]


def test_via_csv(saved):
    shape = json.dumps(VIA_REGION["shape_attributes"]).replace('"', '""')
    text = (
        "filename,file_size,file_attributes,region_count,region_id,region_shape_attributes,region_attributes\n"
        f'IMG_1.jpg,123,"{{}}",1,0,"{shape}","{{""class"":""moraine""}}"\n'
    )
    (found,) = read_features(saved(text, "via.csv"))
    assert (found.kind, found.label) == ("line", "moraine")


def test_geojson_in_pixels_and_in_qgis_upside_down_pixels(saved):
    def collection(*geometries):
        return {
            "type": "FeatureCollection",
            "features": [
                {"type": "Feature", "properties": {"photo": "IMG_1.jpg", "name": "x", "n": 3}, "geometry": g}
                for g in geometries
            ],
        }

    ring = [[0, 0], [10, 0], [10, 10], [0, 0]]
    found = read_features(
        saved(
            collection(
                {"type": "Point", "coordinates": [3, 4, 99]},
                {"type": "MultiLineString", "coordinates": [[[0, 1], [2, 3]], [[4, 5], [6, 7]]]},
                {"type": "Polygon", "coordinates": [ring]},
                {"type": "LineString", "coordinates": [[10.5, -20.5], [30.5, -40.5]]},
                None,
            )
        )
    )
    assert [f.kind for f in found] == ["point", "line", "line", "polygon", "line"]
    assert found[0].parts[0].tolist() == [[3, 4]] and found[0].attributes["n"] == 3
    assert found[3].parts[0].tolist() == [[0, 0], [10, 0], [10, 10]]
    assert found[4].parts[0].tolist() == [[10, 20], [30, 40]]


def test_csv_points_lines_and_areas_by_group(saved):
    text = "photo;feature;kind;x_px;y_px;label\nIMG_1.jpg;1;line;0;1;a\nIMG_1.jpg;1;line;2;3;a\n"
    text += "IMG_1.jpg;2;polygon;0;0;b\nIMG_1.jpg;2;polygon;4;0;b\nIMG_1.jpg;2;polygon;4;4;b\nIMG_2.jpg;1;;7;8;c\n"
    found = read_features(saved(text, "pixels.csv"))
    assert [(f.kind, f.photo, len(f.parts[0])) for f in found] == [
        ("line", "IMG_1.jpg", 2), ("polygon", "IMG_1.jpg", 3), ("point", "IMG_2.jpg", 1),
    ]  # fmt: skip


def test_a_plain_table_of_two_columns_gives_points_for_any_photo(saved):
    found = read_features(saved("\ufeffcolumn,row\n1.5,2\n3,4\n", "xy.csv"))
    assert [f.parts[0].tolist() for f in found] == [[[1.5, 2]], [[3, 4]]]
    assert {f.photo for f in found} == {""}


@pytest.mark.parametrize(
    ("content", "name", "words"),
    [
        ("{", "a.json", "not valid JSON"),
        ('{"a": 1}', "a.json", "not in the format of LabelMe"),
        ("[1, 2]", "a.json", "not in the format of LabelMe"),
        ('{"shapes": [{"label": "x"}]}', "a.json", "incomplete"),
        ('{"shapes": [{"points": [[1, null]]}]}', "a.json", "incomplete"),
        ('{"type": "FeatureCollection", "features": [{"geometry": {"type": "Sphere"}}]}', "a.json", "incomplete"),
        ("easting,northing\n1,2\n", "a.csv", "columns x and y"),
        ("x,y\n1,north\n", "a.csv", "line 2"),
        ("", "a.csv", "columns x and y"),
    ],
)
def test_what_cannot_be_read_says_why(saved, content, name, words):
    with pytest.raises(UnreadableFeaturesError, match=words):
        read_features(saved(content, name))


def test_a_missing_or_binary_file_says_so(tmp_path):
    with pytest.raises(UnreadableFeaturesError, match="cannot be opened"):
        read_features(str(tmp_path / "none.csv"))
    (tmp_path / "photo.jpg").write_bytes(b"\xff\xd8\xff\xe0\x00\x10JFIF")
    with pytest.raises(UnreadableFeaturesError, match="UTF-8"):
        read_features(str(tmp_path / "photo.jpg"))


JSON = st.recursive(
    st.none() | st.booleans() | st.floats(allow_nan=True) | st.text(max_size=8),
    lambda inner: st.lists(inner, max_size=4)
    | st.dictionaries(
        st.sampled_from(["shapes", "points", "images", "annotations", "type", "features", "geometry", "coordinates",
                         "regions", "shape_attributes", "filename", "segmentation", "id", "shape_type", "name"]),
        inner, max_size=5),
    max_leaves=20,
)  # fmt: skip


@settings(max_examples=150, deadline=None)
@given(JSON)
def test_no_json_at_all_raises_anything_else(tmp_path_factory, data):
    path = tmp_path_factory.getbasetemp() / "fuzz.json"
    path.write_text(json.dumps(data), encoding="utf-8")
    try:
        found = read_features(str(path))
    except UnreadableFeaturesError:
        return
    assert all(isinstance(feature, PixelFeature) for feature in found)


def test_only_a_picture_hung_below_zero_is_turned_over():
    part = np.array([[1.0, 2.0], [3.0, -0.4]])
    assert downward((part,))[0] is part
    assert downward(()) == ()
    with pytest.raises(ValueError, match="kind"):
        PixelFeature("a", "circle", ())


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("photo,x,y\na.jpg,nan,4\n", "line 2 has no numbers for x and y"),
        ("photo,x,y\na.jpg,1,2\na.jpg,1e999,4\n", "line 3 has no numbers for x and y"),
        ("photo,x,y\n" + "a" * 200_000 + ",1,2\n", "an entry is incomplete"),
        (
            'filename,region_shape_attributes\na.jpg,"{""name"":""point"",""cx"":NaN,""cy"":2}"\n',
            "line 2 is incomplete",
        ),
        ({"shapes": [{"points": [[10**400, 1]], "shape_type": "point"}]}, "an entry is incomplete"),
        (
            '{"type":"Feature","properties":{},"geometry":'
            + '{"type":"GeometryCollection","geometries":[' * 3000
            + "]}" * 3000
            + "}",
            "is incomplete|not valid JSON",
        ),
    ],
)
def test_what_fuzzing_found_is_refused_in_a_sentence(saved, content, said):
    with pytest.raises(UnreadableFeaturesError, match=said) as caught:
        read_features(saved(content))
    assert str(caught.value).endswith(".")
