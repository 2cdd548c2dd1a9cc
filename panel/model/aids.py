"""Landmarks, drawn skylines and sky masks in the tables and files that Orient photos reads, by photograph.

A folder holds `landmarks.geojson` (points with photo, x, y, elevation, body), `skylines.csv` (photo, column, row) and
`sky_masks/` with one PNG per photograph. The strokes and the brush behind a mask are kept in `drawings.json`, so that
they can be changed later.
"""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path
from typing import Any

from qgis.core import QgsProviderRegistry

from ...algorithms.shared.outputs import unwritable
from ...core.base.errors import UnreadableFeaturesError
from ...core.base.messages import Message
from ...core.base.sun_moon import BODIES
from .solving import skyline_of, write_mask

LANDMARKS, SKYLINES, MASKS, DRAWINGS = "landmarks.geojson", "skylines.csv", "sky_masks", "drawings.json"
FOLDER_NAME = "photo_view"
FOLDER_PROPERTY = "skyline_viewshed/aids_folder"


def aids_folder(layer, project, path):
    """Folder of a layer: the chosen one, else beside the layer's file, the project, or the photograph.

    Parameters
    ----------
    layer : QgsVectorLayer
    project : QgsProject
    path : str or None
        Of the photograph.
    """
    chosen = layer.customProperty(FOLDER_PROPERTY, "")
    if chosen:
        return Path(chosen)
    parts = QgsProviderRegistry.instance().decodeUri(layer.providerType(), layer.source())
    homes = [str(Path(parts["path"]).parent) if parts.get("path") else "", project.homePath()]
    homes.append(str(Path(path).parent) if path else "")
    home = next((home for home in homes if home and Path(home).is_dir()), None)
    return None if home is None else Path(home) / FOLDER_NAME


def name_of(path):
    """Name of a photograph in tables: its file and folder, since cameras give the same name in several folders."""
    return f"{Path(path).parent.name}/{Path(path).name}" if Path(path).parent.name else Path(path).name


def means(name, path):
    """Return whether a name in a table, with as many folders as it has, means a photograph."""
    wanted, parts = (str(text).replace("\\", "/").lower().split("/") for text in (name, path))
    return parts[-len(wanted) :] == wanted


def read_aids(folder, path):
    """Read what is kept for a photograph: (landmarks, strokes, anew, brush), as in `Draft`.

    Parameters
    ----------
    folder : Path or None
    path : str or None
        Of the photograph.

    Raises
    ------
    UnreadableFeaturesError
    """
    if folder is None or not path:
        return (), (), False, ()
    from ...core.skyline.repair import BrushStroke

    marks = tuple(
        _hint(feature["properties"], _place(feature), _body(feature))
        for feature in _features(folder)
        if _is_landmark_of(feature, path)
    )
    drawn: dict[str, Any] = next((drawn for name, drawn in _drawings(folder).items() if means(name, path)), {})
    strokes = tuple(tuple(map(tuple, stroke)) for stroke in drawn.get("strokes", []))
    brush = tuple(BrushStroke(tuple(map(tuple, s["points"])), s["radius"]) for s in drawn.get("brush", []))
    return marks, strokes, bool(drawn.get("anew", False)), brush


def write_aids(folder, path, draft, evidence):
    """Write what a draft holds besides the pose, in place of what was kept for the photograph.

    Parameters
    ----------
    folder : Path
        Made if it is missing.
    path : str
        Of the photograph.
    draft : Draft
    evidence : SkylineEvidence or None

    Raises
    ------
    OutputError, UnreadableFeaturesError
    """
    try:
        _write_all(folder, path, draft, evidence)
    except OSError as error:
        raise unwritable(error.filename or folder, error) from None


def _write_all(folder, path, draft, evidence):
    folder.mkdir(parents=True, exist_ok=True)
    _write_landmarks(folder, path, draft)
    line, rows = skyline_of(draft, evidence)
    _write_skyline(folder, path, line)
    mask = folder / MASKS / f"{Path(name_of(path)).with_suffix('.png')}"
    if rows is not None:
        mask.parent.mkdir(parents=True, exist_ok=True)
        write_mask(str(mask), rows, evidence)
    elif mask.exists():
        mask.unlink()
    drawings = {name: drawn for name, drawn in _drawings(folder).items() if not means(name, path)}
    if draft.strokes or draft.brush:
        brush = [{"points": stroke.points, "radius": stroke.radius_px} for stroke in draft.brush]
        drawings[name_of(path)] = {"strokes": draft.strokes, "anew": draft.anew, "brush": brush}
    _write_text(folder / DRAWINGS, json.dumps(drawings))


def _features(folder):
    return _json(folder / LANDMARKS).get("features", [])


def _is_landmark_of(feature, path):
    """Tell whether a GeoJSON feature is a landmark that the panel edits: with a pixel, and with a place or a body."""
    values = feature.get("properties") or {}
    known = values.get("photo") and None not in (values.get("x"), values.get("y"))
    body = _body(feature)
    shows = body in BODIES if body else None not in _place(feature)
    return bool(known and shows and means(values["photo"], path))


def _hint(values, place, body):
    from ...core.base.landmark_hint import LandmarkHint

    return LandmarkHint(values["x"], values["y"], place[0], place[1], values.get("elevation"), body=body or None)


def _place(feature):
    place = (feature.get("geometry") or {}).get("coordinates") or ()
    return tuple(place[:2]) if len(place) >= 2 else (None, None)


def _body(feature):
    return str((feature.get("properties") or {}).get("body") or "").strip().lower()


def _write_landmarks(folder, path, draft):
    features = [feature for feature in _features(folder) if not _is_landmark_of(feature, path)]
    for mark in draft.landmarks:
        values = {"photo": name_of(path), "x": mark.x_px, "y": mark.y_px, "elevation": mark.elevation_m}
        if mark.body:
            values["body"] = mark.body
        known = mark.longitude_deg is not None
        place = {"type": "Point", "coordinates": [mark.longitude_deg, mark.latitude_deg]} if known else None
        features.append({"type": "Feature", "properties": values, "geometry": place})
    if features or (folder / LANDMARKS).exists():
        _write_text(folder / LANDMARKS, json.dumps({"type": "FeatureCollection", "features": features}, indent=1))


def _write_skyline(folder, path, line):
    rows = []
    if (folder / SKYLINES).exists():
        with open(folder / SKYLINES, newline="", encoding="utf-8") as file:
            rows = [row for row in list(csv.reader(file))[1:] if len(row) == 3 and not means(row[0], path)]
    rows += [[name_of(path), f"{x:.2f}", f"{y:.2f}"] for x, y in line or ()]
    if rows or (folder / SKYLINES).exists():
        text = io.StringIO()
        csv.writer(text, lineterminator="\n").writerows([["photo", "column", "row"], *rows])
        _write_text(folder / SKYLINES, text.getvalue())


def _drawings(folder):
    return _json(folder / DRAWINGS)


def _json(path):
    """Content of a file, {} if there is none. A damaged one is a fault, so that nothing is written over it."""
    if not path.exists():
        return {}
    try:
        content = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        raise UnreadableFeaturesError(path, Message("it is not JSON. Mend it, or delete it.")) from None
    return content if isinstance(content, dict) else {}


def _write_text(path, text):
    from ...core.io.whole_file import staged

    with staged(path) as stage:
        (stage / path.name).write_text(text, encoding="utf-8")
