"""Read image features drawn with labelling tools: LabelMe, COCO, VIA, GeoJSON in pixels, plain CSV.

LabelMe, COCO and VIA place the origin at the upper left *corner* of the picture, half a pixel before the centre of the
first pixel, which is the origin in this program; their coordinates are shifted by that half pixel. CSV and GeoJSON are
assumed to have this program's origin, unless all y are negative (see `base.pixel_features.downward`).

References
----------
.. [1] COCO data format: https://cocodataset.org/#format-data
.. [2] VGG Image Annotator: Dutta, A., Zisserman, A., The VIA annotation software, ACM Multimedia 2019,
   doi:10.1145/3343031.3350535.
"""

from __future__ import annotations

import csv
import io
import json
import os

import numpy as np

from ..base.errors import UnreadableFeaturesError
from ..base.messages import Message
from ..base.pixel_features import PixelFeature, downward, ellipse, open_ring

CORNER_PX = 0.5
MAX_BYTES = 200_000_000
INCOMPLETE = (KeyError, IndexError, TypeError, ValueError, AttributeError, OverflowError, RecursionError)
"""Errors raised if a file has the form of a format but incomplete content."""

_PHOTO = ("photo", "image", "filename", "file_name", "file", "path", "imagepath", "#filename")
_X = ("x", "x_px", "px", "pixel_x", "col", "column", "u", "image_x")
_Y = ("y", "y_px", "py", "pixel_y", "row", "line", "v", "image_y")
_LABEL = ("label", "class", "name", "category")
_GROUP = ("feature", "group", "fid", "feature_id", "object", "line_id", "polygon_id")
_KIND = ("kind", "type", "geometry", "shape")


def read_features(path):
    """Read a file of drawn image features.

    Parameters
    ----------
    path : str

    Returns
    -------
    list of PixelFeature

    Raises
    ------
    UnreadableFeaturesError
    """
    text = _text(path)
    if text.lstrip()[:1] in ("{", "["):
        return _from_json(path, text)
    try:
        return _from_csv(path, text)
    except csv.Error as error:  # for example a null character, or a field of more than 128 kB
        raise UnreadableFeaturesError(path, _incomplete(error)) from None


def _text(path):
    try:
        if os.path.getsize(path) > MAX_BYTES:
            raise UnreadableFeaturesError(path, Message("it is larger than 200 MB. Split it by photograph."))
        with open(path, encoding="utf-8-sig") as file:
            return file.read()
    except UnicodeDecodeError:
        raise UnreadableFeaturesError(path, Message("it is not UTF-8 text. Export it as JSON or CSV.")) from None
    except OSError as error:
        reason = Message("it cannot be opened ({reason}). Check the path and the permissions.", reason=error.strerror)
        raise UnreadableFeaturesError(path, reason) from None


def _from_json(path, text):
    try:
        data = json.loads(text)
    except (ValueError, RecursionError):
        raise UnreadableFeaturesError(path, Message("it is not valid JSON. Export it again.")) from None
    for fits, read in (
        (lambda d: "shapes" in d, _labelme),
        (lambda d: "annotations" in d and "images" in d, _coco),
        (lambda d: d.get("type") in ("FeatureCollection", "Feature"), _geojson),
        (lambda d: "_via_img_metadata" in d, lambda d: _via(d["_via_img_metadata"])),
        (lambda d: any(isinstance(v, dict) and "regions" in v for v in d.values()), _via),
    ):
        if isinstance(data, dict) and fits(data):
            try:
                return read(data)
            except INCOMPLETE as error:
                raise UnreadableFeaturesError(path, _incomplete(error)) from None
    raise UnreadableFeaturesError(
        path,
        Message(
            "it is not in the format of LabelMe, COCO, VIA or GeoJSON. Export it in one of these formats, or "
            "as CSV with the columns photo, x and y."
        ),
    )


def _incomplete(error):
    return Message("an entry is incomplete ({reason}). Export the file again.", reason=f"{error!r:.120}")


def _labelme(data):
    features = []
    for shape in data["shapes"]:
        points, kind = _corner(shape["points"]), shape.get("shape_type") or "polygon"
        if kind == "rectangle":
            points, kind = _box(*points.min(axis=0), *points.max(axis=0)), "polygon"
        elif kind == "circle":
            points, kind = ellipse(points[0], float(np.hypot(*(points[1] - points[0])))), "polygon"
        elif kind in ("linestrip", "line"):
            kind = "line"
        elif kind in ("point", "points"):
            kind = "point"
        elif kind != "polygon":
            continue  # masks and similar shapes have no outline
        features.append(_feature(data.get("imagePath") or "", kind, [points], shape.get("label")))
    return features


def _coco(data):
    names = {image["id"]: image.get("file_name", "") for image in data["images"]}
    classes = {c["id"]: c.get("name", "") for c in data.get("categories", [])}
    features = []
    for entry in data["annotations"]:
        photo, label = names.get(entry.get("image_id"), ""), classes.get(entry.get("category_id"), "")
        outline = entry.get("segmentation")
        if isinstance(outline, list) and outline:
            # Several polygons of one object are separate parts in COCO, never holes.
            features += [_feature(photo, "polygon", [_corner(ring)], label) for ring in outline]
        elif entry.get("keypoints"):
            points = np.asarray(entry["keypoints"], float).reshape(-1, 3)
            points = points[points[:, 2] > 0, :2]
            if len(points):
                features.append(_feature(photo, "point", [_corner(points)], label))
        elif entry.get("bbox"):
            x, y, width, height = _corner([[*entry["bbox"][:2]]])[0].tolist() + list(map(float, entry["bbox"][2:4]))
            features.append(_feature(photo, "polygon", [_box(x, y, x + width, y + height)], label))
    return features


def _via(data):
    features = []
    for picture in data.values():
        regions = picture["regions"]
        for region in regions.values() if isinstance(regions, dict) else regions:
            drawn = _via_shape(region["shape_attributes"])
            if drawn is not None:
                given = region.get("region_attributes") or {}
                features.append(_feature(picture["filename"], *drawn, _first(given), _plain(given)))
    return features


def _via_shape(shape):
    """Give the kind and the parts of a VIA region, or None if it is unknown."""
    name = shape.get("name")
    if name in ("polygon", "polyline"):
        points = _corner(list(zip(shape["all_points_x"], shape["all_points_y"])))
        return ("polygon" if name == "polygon" else "line"), [points]
    if name == "point":
        return "point", [_corner([[shape["cx"], shape["cy"]]])]
    if name == "rect":
        x, y = _corner([[shape["x"], shape["y"]]])[0]
        return "polygon", [_box(x, y, x + float(shape["width"]), y + float(shape["height"]))]
    if name in ("circle", "ellipse"):
        centre = _corner([[shape["cx"], shape["cy"]]])[0]
        radius = shape.get("r", shape.get("rx")), shape.get("r", shape.get("ry"))
        return "polygon", [ellipse(centre, float(radius[0]), float(radius[1]))]
    return None


def _geojson(data):
    features = []
    for entry in data["features"] if data["type"] == "FeatureCollection" else [data]:
        geometry, given = entry.get("geometry"), entry.get("properties") or {}
        if not geometry:
            continue
        lower = {str(key).lower(): value for key, value in given.items()}
        photo = next((lower[name] for name in _PHOTO if lower.get(name)), "")
        label = next((lower[name] for name in _LABEL if lower.get(name)), "")
        for kind, parts in _geometry_parts(geometry):
            parts = [np.asarray([place[:2] for place in part], float) for part in parts]
            features.append(_feature(photo, kind, downward(parts), label, _plain(given)))
    return features


def _geometry_parts(geometry):
    kind, places = geometry["type"], geometry.get("coordinates")
    if kind == "GeometryCollection":
        return [item for part in geometry["geometries"] for item in _geometry_parts(part)]
    return {
        "Point": lambda: [("point", [[places]])],
        "MultiPoint": lambda: [("point", [places])],
        "LineString": lambda: [("line", [places])],
        "MultiLineString": lambda: [("line", [line]) for line in places],
        "Polygon": lambda: [("polygon", places)],
        "MultiPolygon": lambda: [("polygon", rings) for rings in places],
    }[kind]()


def _from_csv(path, text):
    first = text.split("\n", 1)[0]
    delimiter = max(",;\t", key=first.count)
    rows = csv.DictReader(io.StringIO(text), delimiter=delimiter)
    names = {(name or "").strip().lower(): name for name in rows.fieldnames or []}
    if "region_shape_attributes" in names:
        return _via_csv(path, rows)
    x, y = (next((names[n] for n in wanted if n in names), None) for wanted in (_X, _Y))
    if x is None or y is None:
        raise UnreadableFeaturesError(
            path, Message("it has no columns x and y (pixels). Name its columns photo, x and y.")
        )
    photo, label, group, kind = (
        next((names[n] for n in wanted if n in names), None) for wanted in (_PHOTO, _LABEL, _GROUP, _KIND)
    )
    collected = {}
    for number, row in enumerate(rows):
        try:
            place = float(row[x]), float(row[y])
        except (TypeError, ValueError):
            place = np.nan, np.nan
        if not np.isfinite(place).all():
            raise UnreadableFeaturesError(
                path, Message("line {number} has no numbers for x and y. Correct that line.", number=number + 2)
            )
        # Rows of one group are the vertices of one line or area, in order; without a group each row is a point.
        named = (row.get(photo) or "") if photo else ""
        key = (named, row.get(group) or number) if group else (named, number)
        collected.setdefault(key, (row, []))[1].append(place)
    features = []
    for row, places in collected.values():
        shape = _kind_of(row.get(kind) if kind else None, len(places))
        given = _plain({name: value for name, value in row.items() if name and name not in (x, y)})
        parts = downward([np.asarray(places, float)])
        features.append(_feature((row.get(photo) or "") if photo else "", shape, parts, row.get(label) if label else "",
                                 given))  # fmt: skip
    return features


def _kind_of(word, count):
    word = (word or "").strip().lower()
    if word.startswith(("poly", "area", "ring")) and word != "polyline":
        return "polygon"
    if word in ("line", "linestring", "linestrip", "polyline"):
        return "line"
    return "point" if count == 1 or word == "point" else "line"


def _via_csv(path, rows):
    features = []
    for number, row in enumerate(rows):
        try:
            shape = json.loads(row["region_shape_attributes"] or "{}")
            given = json.loads(row.get("region_attributes") or "{}")
            drawn = _via_shape(shape)
            if drawn is not None:
                photo = row.get("filename") or row.get("#filename") or ""
                features.append(_feature(photo, *drawn, _first(given), _plain(given)))
        except INCOMPLETE as error:
            reason = Message(
                "line {number} is incomplete ({reason}). Correct that line.",
                number=number + 2,
                reason=f"{error!r:.120}",
            )
            raise UnreadableFeaturesError(path, reason) from None
    return features


def _feature(photo, kind, parts, label="", attributes=None):
    parts = tuple(open_ring(part) if kind == "polygon" else np.asarray(part, float).reshape(-1, 2) for part in parts)
    if not all(np.isfinite(part).all() and len(part) for part in parts):
        raise ValueError("a vertex is not a number")
    return PixelFeature(str(photo), kind, parts, "" if label is None else str(label), attributes or {})


def _corner(points):
    return np.asarray(points, float).reshape(-1, 2) - CORNER_PX


def _box(left, top, right, bottom):
    return np.array([[left, top], [right, top], [right, bottom], [left, bottom]])


def _first(given):
    return next((value for value in given.values() if isinstance(value, (str, int, float))), "")


def _plain(given):
    return {str(key): value for key, value in given.items() if isinstance(value, (str, int, float))}
