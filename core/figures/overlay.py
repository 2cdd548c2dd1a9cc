"""The overlay for checking a match by eye: evidence, extracted skyline and DEM horizons over the photograph.

Cyan shows the skyline in the picture, orange the DEM's horizon at the answer, dashed magenta and violet the
alternatives. Dark casings keep the lines legible on snow and on rock. `overlay_image` burns everything into pixels;
`overlay_svg_lines` and `evidence_rgba` provide the same content as layers that a page can switch on and off.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.ndimage import gaussian_filter1d

from ..base.overlay_lines import full_size, photo_lines
from .raster import LineStyle, TypeStyle, draw_dot, draw_line, draw_words, resized, tint, words_width
from .svg import element, polyline_path
from .text import azimuth

EXTRACTED = (39, 224, 255)
BEST = (255, 154, 31)
ALTERNATIVES = ((255, 110, 230), (190, 150, 255))
EVIDENCE = (0, 255, 200)
EVIDENCE_OPACITY = 0.55
EVIDENCE_FULL = 0.15
"""Probability per row at which the tint is full; a sharp boundary reaches several times as much on its row."""


def overlay_image(photo, width_px=1280, evidence=True, legend=True, say=str):
    """Draw everything known about a photograph's skyline over its picture.

    Parameters
    ----------
    photo : OrientedPhoto
        Photograph with a preview; anything else that is missing is left out.
    width_px : int
        Width of the result [pixels]; the height follows from the picture.
    evidence : bool
        Tint the rows where the boundary may lie.
    legend : bool
        Explain the colours, with the headings.
    say : callable
        Translates the fixed English words; see `core.figures.text`.

    Returns
    -------
    uint8 (h, w, 3) array
    """
    if photo.preview is None:
        raise ValueError(f"no preview of {photo.path} to draw on")
    full_width, full_height = full_size(photo)
    height_px = max(round(full_height * width_px / full_width), 1)
    pixels = resized(np.asarray(photo.preview)[..., :3], width_px, height_px).copy()
    if evidence and photo.evidence is not None:
        alpha = resized(_evidence_alpha(photo.evidence), width_px, height_px)
        tint(pixels, alpha * (EVIDENCE_OPACITY / 255), EVIDENCE)
    extracted, horizons = photo_lines(photo)
    scale, unit = width_px / full_width, max(max(width_px, height_px) / 1280, 0.75)
    for rank, horizon in reversed(list(enumerate(horizons))):
        if rank == 0 and extracted is not None:
            _draw(pixels, extracted, scale, EXTRACTED, 4.5 * unit, LineStyle(casing_px=1.2 * unit, opacity=0.85))
        colour = BEST if rank == 0 else ALTERNATIVES[rank - 1]
        dash = None if rank == 0 else (9 * unit, 6 * unit)
        _draw(pixels, horizon, scale, colour, 2 * unit, LineStyle(dash, unit))
    if not horizons and extracted is not None:
        _draw(pixels, extracted, scale, EXTRACTED, 3 * unit, LineStyle(casing_px=1.2 * unit))
    if legend:
        _legend(pixels, photo, extracted is not None, len(horizons), unit, say)
    return pixels


def evidence_rgba(evidence, width_px=512):
    """Draw the evidence as a tint: uint8 (h, w, 4) RGBA, with 16 levels of opacity so that it compresses well."""
    alpha = _evidence_alpha(evidence)
    rows, columns = alpha.shape
    if columns > width_px:
        alpha = resized(alpha, width_px, max(round(rows * width_px / columns), 1))
    alpha = (np.rint(alpha / 17.0) * 17 * EVIDENCE_OPACITY).astype(np.uint8)
    colour = np.broadcast_to(np.array(EVIDENCE, np.uint8), (*alpha.shape, 3))
    return np.dstack([np.where(alpha[..., None] > 0, colour, 0).astype(np.uint8), alpha])


def overlay_svg_lines(photo, key, span=1000.0):
    """Draw the lines as SVG, in a coordinate system in which the picture is `span` wide.

    Parameters
    ----------
    photo : OrientedPhoto
    key : str
        Prefix of the element ids, unique in the page.
    span : float
        Width of the picture in drawing units.

    Returns
    -------
    str
        Groups of class 'line-extracted', 'line-best', 'line-alternative'; strokes keep their width when zoomed.
    """
    extracted, horizons = photo_lines(photo)
    factor = span / full_size(photo)[0]
    layers = [(f"line-alternative rank{rank + 1}", horizons[rank]) for rank in range(len(horizons) - 1, 0, -1)]
    layers += [("line-extracted", extracted)] if extracted is not None else []
    layers += [("line-best", horizons[0])] if horizons else []
    return "".join(_svg_line(line, f"{key}-{index}", class_, factor) for index, (class_, line) in enumerate(layers))


def focus_box(photo, aspect=2.2):
    """Find the part of the picture that matters for the check: full width, around the skyline, `aspect` wide to high.

    Returns
    -------
    (x, y, width, height) in pixels of the full upright picture; the whole picture if it is no taller.
    """
    width, height = full_size(photo)
    extracted, horizons = photo_lines(photo)
    lines = [line for line in [extracted, *horizons[:1]] if line is not None]
    rows = [line.y_px[(line.x_px >= 0) & (line.x_px < width)] for line in lines]
    rows = np.concatenate(rows) if rows else np.zeros(0)
    rows = rows[np.isfinite(rows) & (rows >= 0) & (rows < height)]
    if not len(rows):
        return 0.0, 0.0, float(width), float(height)
    top, bottom = np.percentile(rows, [1, 99])
    tall = min(max(width / aspect, 1.35 * (bottom - top) + 0.04 * height), height)
    first = np.clip((top + bottom) / 2 - tall / 2, 0, height - tall)
    return 0.0, float(first), float(width), float(tall)


def _evidence_alpha(evidence):
    probability = np.asarray(evidence.probability, np.float32)
    smooth = gaussian_filter1d(probability, 1.5, axis=0, mode="constant")
    flat = 1.5 / max(probability.shape[0], 1)  # a column without information stays clear
    return np.rint(255 * np.sqrt(np.clip((smooth - flat) / EVIDENCE_FULL, 0, 1))).astype(np.uint8)


def _draw(pixels, line, scale, colour, width, style):
    for doubtful in (True, False):
        x, y = line.part(doubtful)
        x, y = (x + 0.5) * scale - 0.5, (y + 0.5) * scale - 0.5
        dash = (2.5 * width, width if style.dash_px is None else 3 * width) if doubtful else style.dash_px
        draw_line(pixels, x, y, colour, width, replace(style, dash_px=dash))


def _svg_line(line, key, class_, factor):
    parts = []
    for doubtful in (False, True):
        x, y = line.part(doubtful)
        path = polyline_path((x + 0.5) * factor, (y + 0.5) * factor)
        if path:
            name = f"{key}{'d' if doubtful else ''}"
            parts.append(element("path", id=name, d=path, class_="doubtful" if doubtful else None))
            parts.insert(0, element("use", class_="casing", **{"xlink:href": f"#{name}"}))
    return element("g", "".join(parts), class_=class_) if parts else ""


def _legend(pixels, photo, has_extracted, horizons, unit, say):
    size, entries = 17 * unit, []
    if has_extracted:
        entries.append((EXTRACTED, say("extracted skyline")))
    for rank in range(horizons):
        heading = azimuth(photo.orientation.candidates[rank].pose.heading_deg)
        words = say("DEM horizon at {heading}").format(heading=heading) if rank == 0 else f"{rank + 1}: {heading}"
        entries.append((BEST if rank == 0 else ALTERNATIVES[rank - 1], words))
    at, base = 16 * unit, pixels.shape[0] - 14 * unit
    for colour, words in entries:
        draw_dot(pixels, at + 5 * unit, base - 5 * unit, 5 * unit, colour, unit)
        draw_words(pixels, at + 16 * unit, base, words, colour, TypeStyle(size, casing_px=max(round(2 * unit), 1)))
        at += 34 * unit + words_width(words, size)
