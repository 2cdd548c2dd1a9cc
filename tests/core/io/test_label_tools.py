"""Shapes of labelling tools that are no plain polygon, and what is said of those that cannot be read."""

from __future__ import annotations

import base64
import io
import json

import numpy as np
import pytest
from skyline_viewshed.core.base.errors import UnreadableFeaturesError
from skyline_viewshed.core.io.features import read_features


@pytest.fixture
def read(tmp_path):
    def call(content):
        path = tmp_path / "labels.json"
        path.write_text(json.dumps(content), encoding="utf-8")
        return read_features(str(path))

    return call


def coco(*annotations):
    return {"images": [{"id": 1, "file_name": "a.jpg", "width": 8, "height": 6}], "annotations": list(annotations)}


def test_coco_run_lengths_are_the_mask_and_not_its_box(read):
    mask = np.zeros((6, 8), bool)
    mask[1:5, 2:4] = mask[4, 2:7] = True  # an L
    flat = np.concatenate([[False], mask.T.ravel(), [True]])
    counts = np.diff(np.concatenate([[0], np.flatnonzero(np.diff(flat.astype(int)))])).tolist()
    entry = {"image_id": 1, "segmentation": {"size": [6, 8], "counts": counts}, "bbox": [2, 1, 5, 4], "iscrowd": 1}
    (found,), notes = read(coco(entry))
    assert not notes and found.size_px == (8, 6) and len(found.parts) == 1
    corners = {(2, 1), (4, 1), (4, 4), (7, 4), (7, 5), (2, 5)}
    assert {tuple(corner + 0.5) for corner in found.parts[0]} == corners


def test_what_coco_and_labelme_leave_unreadable_is_said_by_kind_and_count(read):
    found, notes = read(coco({"image_id": 1}, {"image_id": 1, "segmentation": []}))
    assert found == [] and "annotation (2)" in str(notes[0])
    shapes = [{"shape_type": "cuboid", "points": [[1, 2]]}, {"shape_type": "mask", "points": [[1, 2], [3, 4]]}]
    found, notes = read({"shapes": shapes, "imagePath": "a.jpg"})
    assert found == [] and "cuboid (1), mask (1)" in str(notes[0])
    regions = [{"shape_attributes": {"name": "spiral"}, "region_attributes": {}}]
    found, notes = read({"a.jpg1": {"filename": "a.jpg", "size": 1, "regions": regions}})
    assert found == [] and "spiral (1)" in str(notes[0])


def test_a_csv_of_via_tells_what_it_leaves_out_but_not_of_pictures_without_regions(tmp_path):
    rows = ["filename,file_size,region_shape_attributes,region_attributes", "a.jpg,1,{},{}"]
    rows += [f'b.jpg,1,"{{""name"":""{kind}"",""cx"":3,""cy"":4}}",{{}}' for kind in ("point", "spiral")]
    path = tmp_path / "via.csv"
    path.write_text("\n".join(rows), encoding="utf-8")
    (found,), (note,) = read_features(str(path))
    assert found.photo == "b.jpg" and str(note).endswith("spiral (1).")


@pytest.mark.parametrize("damage", [b"no picture", b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR"])
def test_a_damaged_labelme_mask_is_a_fault_of_the_file(read, damage):
    pytest.importorskip("PIL.Image")
    shape = {"shape_type": "mask", "points": [[1, 2], [3, 4]], "mask": base64.b64encode(damage).decode()}
    with pytest.raises(UnreadableFeaturesError):
        read({"shapes": [shape], "imagePath": "a.jpg"})


def test_a_labelme_mask_lies_where_its_box_is(read):
    image = pytest.importorskip("PIL.Image")
    stream = io.BytesIO()
    image.fromarray(np.array([[0, 255], [255, 255]], np.uint8)).save(stream, "PNG")
    shape = {"shape_type": "mask", "points": [[10, 20], [12, 22]], "label": "ice"}
    shape["mask"] = base64.b64encode(stream.getvalue()).decode()
    (found,), notes = read({"shapes": [shape], "imagePath": "a.jpg", "imageWidth": 400, "imageHeight": 300})
    assert not notes and found.size_px == (400, 300) and found.label == "ice"
    assert {tuple(corner + 0.5) for corner in found.parts[0]} == {
        (11, 20),
        (12, 20),
        (12, 22),
        (10, 22),
        (10, 21),
        (11, 21),
    }


def test_a_turned_rectangle_of_labelmes_relatives_is_an_area(read):
    shape = {"shape_type": "rotation", "points": [[5, 0], [10, 5], [5, 10], [0, 5]]}
    (found,), _ = read({"shapes": [shape]})
    assert found.kind == "polygon" and len(found.parts[0]) == 4


def test_via_turns_ellipses_and_records_the_size_of_the_file(read):
    shape = {"name": "ellipse", "cx": 50, "cy": 40, "rx": 20, "ry": 5, "theta": np.pi / 2}
    regions = [{"shape_attributes": shape, "region_attributes": {}}]
    (found,), _ = read({"a.jpg123": {"filename": "a.jpg", "size": 123, "regions": regions}})
    across, down = np.ptp(found.parts[0], axis=0)
    assert (across, down) == pytest.approx((10, 40), abs=0.3) and found.file_bytes == 123


def test_rows_that_qgis_counts_upwards_belong_to_the_stored_picture(read):
    geometry = {"type": "LineString", "coordinates": [[1, -2], [3, -40]]}
    (found,), _ = read({"type": "Feature", "geometry": geometry, "properties": {}})
    assert found.as_stored
