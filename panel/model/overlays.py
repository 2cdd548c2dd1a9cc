"""What is drawn over the picture, as lines and labels in its pixels; the canvas only paints them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ...core.base.camera import in_frame, project
from ...core.base.overlay_lines import horizon_line, skyline_line

HORIZON, CRESTS, SKYLINE, OTHERS = "horizon", "crests", "skyline", "alternatives"
SUMMITS, GRATICULE, MAP = "summits", "graticule", "map"
KINDS = (HORIZON, CRESTS, SKYLINE, OTHERS, SUMMITS, GRATICULE, MAP)
SHOWN_AT_FIRST = (HORIZON, SKYLINE, OTHERS)


@dataclass(frozen=True, eq=False)
class Line:
    """A line, or dots, over the picture.

    Attributes
    ----------
    kind : str
        One of `KINDS`, or 'drawn', 'hidden', 'doubtful', 'landmark'.
    x_px, y_px : (N,) arrays
        Vertices [pixels of the full upright picture]; NaN breaks the line.
    dots : bool
    """

    kind: str
    x_px: Any
    y_px: Any
    dots: bool = False


@dataclass(frozen=True)
class Label:
    """A text at a place of the picture; `kind` as for `Line`."""

    kind: str
    text: str
    x_px: float
    y_px: float


@dataclass(frozen=True, eq=False)
class Trace:
    """A line of the terrain as directions from the eye [degrees], so that it follows every pose."""

    kind: str
    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    visible: bool = True


@dataclass
class Terrestrial:
    """What was found on the terrain for the present eye: traces of map layers, names of points and summits.

    Attributes
    ----------
    traces : list of Trace
    names : list of (text, azimuth, elevation angle)
        Of the map layers' points [degrees].
    summits : list of (text, azimuth, elevation angle)
    """

    traces: list = field(default_factory=list)
    names: list = field(default_factory=list)
    summits: list = field(default_factory=list)


def drawn(session, shown, terrestrial):
    """Lines and labels of the present state.

    Parameters
    ----------
    session : Session
    shown : set of str
        Of `KINDS`.
    terrestrial : Terrestrial

    Returns
    -------
    lines : list of Line
    labels : list of Label
    """
    draft, ground = session.draft, session.ground
    if draft is None:
        return [], []
    lines: list[Line] = []
    labels: list[Label] = []
    camera, pose = draft.camera, draft.pose
    if SKYLINE in shown and session.evidence is not None:
        lines += _skyline(session)
    for stroke in draft.strokes:
        lines.append(Line("drawn", *np.asarray(stroke, float).reshape(-1, 2).T))
    if pose is not None:
        if GRATICULE in shown:
            _add_graticule(lines, labels, camera, pose)
        if OTHERS in shown:
            for number, other in session.alternatives:
                lines.append(_horizon(OTHERS, ground, camera, other))
                labels += _at_top(OTHERS, str(number), lines[-1], camera)
        if ground is not None:
            _add_terrain(lines, labels, session, shown, terrestrial)
    for mark in draft.landmarks:
        lines.append(Line("landmark", np.array([mark.x_px]), np.array([mark.y_px]), dots=True))
    return lines, labels


def _add_terrain(lines, labels, session, shown, terrestrial):
    camera, pose, ground = session.draft.camera, session.draft.pose, session.ground
    if CRESTS in shown:
        lines.append(Line(CRESTS, *project(camera, pose, ground.ridges.azimuth_deg, ground.ridges.elevation_deg), True))
    if MAP in shown:
        for trace in terrestrial.traces:
            place = project(camera, pose, trace.azimuth_deg, trace.elevation_deg)
            lines.append(Line(MAP if trace.visible else "hidden", *place))
        labels += _named(MAP, camera, pose, terrestrial.names)
    if HORIZON in shown:
        line = horizon_line(ground.horizon, camera, pose)
        lines += [Line(HORIZON, *line.part(False)), Line("doubtful", *line.part(True))]
    if SUMMITS in shown:
        labels += _named(SUMMITS, camera, pose, terrestrial.summits)


def _horizon(kind, ground, camera, pose):
    line = horizon_line(ground.horizon, camera, pose)
    return Line(kind, line.x_px, line.y_px)


def _skyline(session):
    """Extracted skyline with what a person did to it."""
    from ...core.skyline.repair import full_size_line
    from .solving import skyline_of

    draft, evidence = session.draft, session.evidence
    line, rows = skyline_of(draft, evidence)
    if line is not None:
        return []
    if rows is not None:
        return [Line(SKYLINE, *full_size_line(evidence, rows))]
    extracted = skyline_line(evidence.best, draft.camera.width_px, draft.camera.height_px)
    return [Line(SKYLINE, *extracted.part(False))]


def _add_graticule(lines, labels, camera, pose):
    from ...core.mapping.graticule import graticule

    for line in graticule(camera, pose):
        lines.append(Line(GRATICULE, line.x_px, line.y_px))
        known = np.flatnonzero(np.isfinite(line.x_px))
        if line.kind == "azimuth":
            at = known[np.argmax(line.y_px[known])]
            labels.append(Label(GRATICULE, f"{line.value_deg:g}°", float(line.x_px[at]), camera.height_px - 1.0))
        else:
            at = known[0]
            labels.append(Label(GRATICULE, f"{line.value_deg:+g}°", 0.0, float(line.y_px[at])))


def _at_top(kind, text, line, camera):
    """Label at the highest point of a line in the picture, if it has one."""
    known = np.flatnonzero(in_frame(camera, line.x_px, line.y_px))
    if not known.size:
        return []
    top = known[np.argmin(line.y_px[known])]
    return [Label(kind, text, float(line.x_px[top]), float(line.y_px[top]))]


def _named(kind, camera, pose, names):
    if not names:
        return []
    x, y = project(camera, pose, [name[1] for name in names], [name[2] for name in names])
    inside = (x > 0) & (x < camera.width_px) & (y > 0) & (y < camera.height_px)
    return [Label(kind, name[0], float(x[k]), float(y[k])) for k, name in enumerate(names) if inside[k]]
