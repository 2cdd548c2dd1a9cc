"""Image features as LabelMe, COCO and VIA write them.

All three place the origin at the upper left *corner* of the picture; see `features`. A shape that cannot be read is
left out, and a note says so.

References
----------
.. [1] COCO data format: https://cocodataset.org/#format-data
.. [2] VGG Image Annotator: Dutta, A., Zisserman, A., The VIA annotation software, ACM Multimedia 2019,
   doi:10.1145/3343031.3350535.
"""

from __future__ import annotations

from collections import Counter

import numpy as np

from ..base.messages import Message
from ..base.pixel_features import PixelFeature, ellipse, open_ring
from .masks import mask_of_picture, mask_of_runs, outlines

CORNER_PX = 0.5
RINGS = ("polygon", "rotation", "quadrilateral", "oriented_rectangle")
"""LabelMe's shapes that list the corners of an area; all but the first belong to programs that write its format."""


def of_labelme(data, notes):
    """Read a LabelMe file; `notes` gets a `Message` on what is left out."""
    unknown: Counter[str] = Counter()
    features = []
    photo, size_px = data.get("imagePath") or "", _size(data.get("imageWidth"), data.get("imageHeight"))
    for shape in data["shapes"]:
        kind = shape.get("shape_type") or "polygon"
        drawn = _labelme_shape(kind, shape)
        if drawn is None:
            unknown[kind] += 1
            continue
        for kind, parts in drawn:
            features.append(make_feature(photo, kind, parts, shape.get("label"), size_px=size_px))
    note_unknown(unknown, notes)
    return features


def _labelme_shape(kind, shape):
    """Kind and parts of each feature of a shape; None if it is unknown."""
    points = _corner(shape["points"])
    if kind == "mask":
        mask = mask_of_picture(shape["mask"]) if shape.get("mask") else None
        return None if mask is None else _areas(mask, points.min(axis=0) + CORNER_PX)
    if kind == "rectangle":
        return [("polygon", [_box(*points.min(axis=0), *points.max(axis=0))])]
    if kind == "circle":
        return [("polygon", [ellipse(points[0], float(np.hypot(*(points[1] - points[0]))))])]
    if kind in ("linestrip", "line"):
        return [("line", [points])]
    if kind in ("point", "points"):
        return [("point", [points])]
    return [("polygon", [points])] if kind in RINGS else None


def _areas(mask, corner=(0.0, 0.0)):
    """Areas of a mask whose upper left corner is `corner`."""
    return [("polygon", [_corner(ring + corner) for ring in rings]) for rings in outlines(mask)]


def of_coco(data, notes):
    """Read a COCO file; `notes` gets a `Message` on what is left out."""
    images = {image["id"]: image for image in data["images"]}
    classes = {c["id"]: c.get("name", "") for c in data.get("categories", [])}
    empty: Counter[str] = Counter()
    features = []
    for entry in data["annotations"]:
        image, label = images.get(entry.get("image_id"), {}), classes.get(entry.get("category_id"), "")
        photo, size_px = image.get("file_name", ""), _size(image.get("width"), image.get("height"))
        drawn = _coco_shape(entry)
        if not drawn:
            empty["annotation"] += 1
        features += [make_feature(photo, kind, parts, label, size_px=size_px) for kind, parts in drawn]
    note_unknown(empty, notes)
    return features


def _coco_shape(entry):
    """Kind and parts of each feature of an annotation."""
    outline = entry.get("segmentation")
    if isinstance(outline, dict):
        return _areas(mask_of_runs(outline))
    if outline:
        # Several polygons of one object are separate parts in COCO, never holes.
        return [("polygon", [_corner(ring)]) for ring in outline]
    if entry.get("keypoints"):
        points = np.asarray(entry["keypoints"], float).reshape(-1, 3)
        points = points[points[:, 2] > 0, :2]
        return [("point", [_corner(points)])] if len(points) else []
    if entry.get("bbox"):
        x, y = _corner([[*entry["bbox"][:2]]])[0].tolist()
        width, height = map(float, entry["bbox"][2:4])
        return [("polygon", [_box(x, y, x + width, y + height)])]
    return []


def of_via(data, notes):
    """Read the pictures of a VIA project; `notes` gets a `Message` on what is left out."""
    unknown: Counter[str] = Counter()
    features = []
    for picture in data.values():
        regions = picture["regions"]
        for region in regions.values() if isinstance(regions, dict) else regions:
            given = region.get("region_attributes") or {}
            drawn = via_shape(region["shape_attributes"])
            if drawn is None:
                unknown[str(region["shape_attributes"].get("name"))] += 1
                continue
            kind, parts = drawn
            feature = make_feature(picture["filename"], kind, parts, first_value(given), plain_values(given),
                                   file_bytes=via_bytes(picture.get("size")))  # fmt: skip
            features.append(feature)
    note_unknown(unknown, notes)
    return features


def via_bytes(size):
    """Size of the picture's file as VIA records it [bytes]; None if it does not."""
    try:
        return int(size) if int(size) > 0 else None
    except (TypeError, ValueError):
        return None


def via_shape(shape):
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
        return "polygon", [ellipse(centre, float(radius[0]), float(radius[1]), float(shape.get("theta") or 0.0))]
    return None


def note_unknown(counted, notes):
    """Note how many shapes of each kind were left out; `counted` holds their numbers by kind."""
    if counted:
        kinds = ", ".join(f"{kind} ({count})" for kind, count in sorted(counted.items()))
        notes.append(Message("Shapes without an outline that can be read were left out: {kinds}.", kinds=kinds))


def _size(width, height):
    """(width, height) of a picture; None if the file does not state both."""
    try:
        size = float(width), float(height)
    except (TypeError, ValueError):
        return None
    return size if min(size) >= 1 and np.isfinite(size).all() else None


def make_feature(photo, kind, parts, label="", attributes=None, **drawn_on):  # parameters: the fields of a feature
    """Make a `PixelFeature` from outside data, whose vertices may be anything.

    Parameters
    ----------
    photo : str
    kind : str
    parts : sequence of (N, 2) arrays
        Closed rings are opened [pixels].
    label : str or None
    attributes : dict or None
    **drawn_on
        `size_px`, `as_stored` or `file_bytes` of the feature.

    Raises
    ------
    ValueError
        A vertex is not a finite number.
    """
    parts = tuple(open_ring(part) if kind == "polygon" else np.asarray(part, float).reshape(-1, 2) for part in parts)
    if not all(np.isfinite(part).all() and len(part) for part in parts):
        raise ValueError("a vertex is not a number")
    return PixelFeature(str(photo), kind, parts, "" if label is None else str(label), attributes or {}, **drawn_on)


def _corner(points):
    return np.asarray(points, float).reshape(-1, 2) - CORNER_PX


def _box(left, top, right, bottom):
    return np.array([[left, top], [right, top], [right, bottom], [left, bottom]])


def first_value(given):
    """First plain value of a region's attributes, or ''."""
    return next((value for value in given.values() if isinstance(value, (str, int, float))), "")


def plain_values(given):
    """Attributes that are text or numbers."""
    return {str(key): value for key, value in given.items() if isinstance(value, (str, int, float))}
