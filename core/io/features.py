"""Read image features drawn with labelling tools: LabelMe, COCO, VIA, GeoJSON in pixels, plain CSV.

LabelMe, COCO and VIA place the origin at the upper left *corner* of the picture, half a pixel before the centre of the
first pixel, which is the origin in this program; their coordinates are shifted by that half pixel. CSV and GeoJSON are
assumed to have this program's origin, unless all y are negative (see `base.pixel_features.downward`).
"""

from __future__ import annotations

import csv
import io
import json
import os
from collections import Counter

import numpy as np

from ..base.errors import UnreadableFeaturesError
from ..base.messages import Message
from ..base.pixel_features import counts_upwards, downward
from .label_tools import (
    first_value,
    make_feature,
    note_unknown,
    of_coco,
    of_labelme,
    of_via,
    plain_values,
    via_bytes,
    via_shape,
)

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
    features : list of PixelFeature
    notes : list of Message
        What was left out.

    Raises
    ------
    UnreadableFeaturesError
    """
    notes: list = []
    text = _text(path)
    if text.lstrip()[:1] in ("{", "["):
        return _from_json(path, text, notes), notes
    try:
        return _from_csv(path, text, notes), notes
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


def _from_json(path, text, notes):
    try:
        data = json.loads(text)
    except (ValueError, RecursionError):
        raise UnreadableFeaturesError(path, Message("it is not valid JSON. Export it again.")) from None
    for fits, read in (
        (lambda d: "shapes" in d, of_labelme),
        (lambda d: "annotations" in d and "images" in d, of_coco),
        (lambda d: d.get("type") in ("FeatureCollection", "Feature"), lambda d, _: _geojson(d)),
        (lambda d: "_via_img_metadata" in d, lambda d, n: of_via(d["_via_img_metadata"], n)),
        (lambda d: any(isinstance(v, dict) and "regions" in v for v in d.values()), of_via),
    ):
        if isinstance(data, dict) and fits(data):
            try:
                return read(data, notes)
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
            made = make_feature(
                photo, kind, downward(parts), label, plain_values(given), as_stored=counts_upwards(parts)
            )
            features.append(made)
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


def _from_csv(path, text, notes):
    first = text.split("\n", 1)[0]
    delimiter = max(",;\t", key=first.count)
    rows = csv.DictReader(io.StringIO(text), delimiter=delimiter)
    names = {(name or "").strip().lower(): name for name in rows.fieldnames or []}
    if "region_shape_attributes" in names:
        return _via_csv(path, rows, notes)
    x, y = (next((names[n] for n in wanted if n in names), None) for wanted in (_X, _Y))
    if x is None or y is None:
        raise UnreadableFeaturesError(
            path, Message("it has no columns x and y (pixels). Name its columns photo, x and y.")
        )
    photo, label, group, kind = (
        next((names[n] for n in wanted if n in names), None) for wanted in (_PHOTO, _LABEL, _GROUP, _KIND)
    )
    collected: dict = {}
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
        given = plain_values({name: value for name, value in row.items() if name and name not in (x, y)})
        parts = [np.asarray(places, float)]
        named, called = (row.get(photo) or "") if photo else "", row.get(label) if label else ""
        drawn_on = {"as_stored": counts_upwards(parts)}
        features.append(make_feature(named, shape, downward(parts), called, given, **drawn_on))
    return features


def _kind_of(word, count):
    word = (word or "").strip().lower()
    if word.startswith(("poly", "area", "ring")) and word != "polyline":
        return "polygon"
    if word in ("line", "linestring", "linestrip", "polyline"):
        return "line"
    return "point" if count == 1 or word == "point" else "line"


def _via_csv(path, rows, notes):
    features: list = []
    unknown: Counter[str] = Counter()
    for number, row in enumerate(rows):
        try:
            shape = json.loads(row["region_shape_attributes"] or "{}")
            given = json.loads(row.get("region_attributes") or "{}")
            drawn = via_shape(shape)
            if drawn is not None:
                photo = row.get("filename") or row.get("#filename") or ""
                size = via_bytes(row.get("file_size"))
                called = first_value(given)
                features.append(make_feature(photo, *drawn, called, plain_values(given), file_bytes=size))
            elif shape:  # a picture without regions has a line with an empty shape
                unknown[str(shape.get("name"))] += 1
        except INCOMPLETE as error:
            reason = Message(
                "line {number} is incomplete ({reason}). Correct that line.",
                number=number + 2,
                reason=f"{error!r:.120}",
            )
            raise UnreadableFeaturesError(path, reason) from None
    note_unknown(unknown, notes)
    return features
