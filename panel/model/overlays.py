"""What is drawn over the picture, as lines and labels in its pixels; the canvas only paints them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from ...core.base.camera import in_frame, project
from ...core.base.overlay_lines import skyline_line
from .identity import same

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


@dataclass(frozen=True, eq=False)
class Drawing:
    """All that is drawn over the picture.

    Attributes
    ----------
    still : tuple of Line
        Lines that do not follow the pose; the same tuple as long as they are the same.
    moving : list of Line
    labels : list of Label
    """

    still: tuple = ()
    moving: list = field(default_factory=list)
    labels: list = field(default_factory=list)


class Overlays:
    """Draws the present state; what does not follow the pose is kept from one frame of a drag to the next."""

    def __init__(self):
        self._for: tuple[Any, ...] = ()
        self._still: tuple[Line, ...] = ()
        self._still_labels: list[Label] = []

    def drawn(self, session, shown, terrestrial):
        """Give the lines and labels of the present state.

        Parameters
        ----------
        session : Session
        shown : set of str
            Of `KINDS`.
        terrestrial : Terrestrial

        Returns
        -------
        Drawing
        """
        draft = session.draft
        if draft is None:
            return Drawing()
        others = session.alternatives if OTHERS in shown and draft.pose is not None else ()
        evidence = session.evidence if SKYLINE in shown else None
        present = evidence, session.ground, others, draft.camera, draft.strokes, draft.brush, draft.anew
        if not same(self._for, present):
            self._for = present
            self._still, self._still_labels = _still(draft, evidence, session.ground, others)
        lines: list[Line] = []
        labels = list(self._still_labels)
        if draft.pose is not None:
            if GRATICULE in shown:
                _add_graticule(lines, labels, draft.camera, draft.pose)
            if session.ground is not None:
                _add_terrain(lines, labels, session, shown, terrestrial)
        for mark in draft.landmarks:
            lines.append(Line("landmark", np.array([mark.x_px]), np.array([mark.y_px]), dots=True))
        return Drawing(self._still, lines, labels)


def _still(draft, evidence, ground, others):
    """Lines and labels that stay where they are while the pose changes."""
    lines: list[Line] = [] if evidence is None else _skyline(draft, evidence)
    labels: list[Label] = []
    for stroke in draft.strokes:
        lines.append(Line("drawn", *np.asarray(stroke, float).reshape(-1, 2).T))
    for number, pose in others:
        line = ground.lines.line(draft.camera, pose)
        lines.append(Line(OTHERS, line.x_px, line.y_px))
        labels += _at_top(OTHERS, str(number), lines[-1], draft.camera)
    return tuple(lines), labels


def _add_terrain(lines, labels, session, shown, terrestrial):
    camera, pose, ground = session.draft.camera, session.draft.pose, session.ground
    if CRESTS in shown:
        x, y = ground.crests.project(camera, pose)
        lines.append(Line(CRESTS, x, y, dots=True))
    if MAP in shown:
        for trace in terrestrial.traces:
            place = project(camera, pose, trace.azimuth_deg, trace.elevation_deg)
            lines.append(Line(MAP if trace.visible else "hidden", *place))
        labels += _named(MAP, camera, pose, terrestrial.names)
    if HORIZON in shown:
        line = ground.lines.line(camera, pose)
        lines += [Line(HORIZON, *line.part(False)), Line("doubtful", *line.part(True))]
    if SUMMITS in shown:
        labels += _named(SUMMITS, camera, pose, terrestrial.summits)


def _skyline(draft, evidence):
    """Extracted skyline with what a person did to it."""
    from ...core.skyline.repair import full_size_line
    from .solving import skyline_of

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
