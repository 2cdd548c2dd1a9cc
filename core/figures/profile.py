"""Drawings of angles along the skyline: the DEM's horizon over the full circle, and the residuals of a match."""

from __future__ import annotations

import numpy as np

from ..base.angles import wrap_360
from .svg import DISTANCE_LIGHT, Scale, area_path, element, figure, line, polyline_path, spans_360, text, ticks
from .text import azimuth, compass_point, is_known, with_unit

DISTANCE_STEPS_M = (500, 1_000, 2_000, 5_000, 10_000, 20_000, 40_000)
"""Limits of the eight distance colours [m]."""

PROFILE_STEP_DEG = 0.5
RESIDUAL_POINTS = 400


def horizon_profile_svg(horizon, heading_deg=None, hfov_deg=None, width=900, height=210, say=str):
    """Draw the horizon's elevation angle over all azimuths, coloured by its distance.

    Parameters
    ----------
    horizon : HorizonProfile
    heading_deg, hfov_deg : float or None
        True heading and horizontal field of view of a photo whose span is to be marked [degrees].
    width, height : float
        Size of the drawing [px].
    say : callable
        Translates the fixed English words; see `core.figures.text`.

    Returns
    -------
    str
        An accessible SVG. Magenta shading: the DEM ends before the horizon may be reached, so the angle is a lower
        bound. Grey: voids, or no data.
    """
    azimuths, elevations, distances, clipped, void = _stepped(horizon)
    if not np.isfinite(elevations).any():
        words = say("The DEM has no horizon here.")
        return figure(width, height, say("Horizon"), words, text(width / 2, height / 2, words, "name", "middle"))
    low = min(float(np.nanmin(elevations)), 0.0) - 0.5
    high = max(float(np.nanmax(elevations)) * 1.08, low + 3)
    x, y = Scale(0, 360, 44, width - 26), Scale(low, high, height - 54, 12)
    parts = [_angle_axis(x, y, say), *_distance_areas(azimuths, elevations, distances, x, y)]
    for mask, class_ in ((clipped, "clipped"), (void | ~np.isfinite(elevations), "unknown")):
        for first, last in _runs(mask):
            start, stop = float(x(first * PROFILE_STEP_DEG)), float(x((last + 1) * PROFILE_STEP_DEG))
            parts.append(element("rect", x=start, y=y.stop, width=stop - start, height=y.start - y.stop, class_=class_))
    parts.append(element("path", d=polyline_path(x(azimuths), y(elevations)), class_="horizon"))
    parts += [_azimuth_axis(x, y, say), *_view_span(heading_deg, hfov_deg, x, y), *_distance_key(x, height, say)]
    return figure(width, height, say("Horizon of the DEM over all azimuths"), _profile_in_words(horizon, say), *parts)


def residuals_svg(residual_px, height_px=None, pixels_per_degree=None, width=420, height=190, say=str):
    """Draw the image skyline minus the projected DEM horizon along the picture's columns.

    Parameters
    ----------
    residual_px : (w,) array
        [pixels of the full picture], positive if the image skyline is lower in the picture; NaN if not compared.
    height_px : float or None
        Height of the full picture, used to give percentages [pixels].
    pixels_per_degree : float or None
        Scale in the middle of the full picture; with it a second axis shows degrees.
    width, height : float
        Size of the drawing [px].
    say : callable
        Translates the fixed English words; see `core.figures.text`.

    Returns
    -------
    str
        An accessible SVG, with up as in the picture: a curve above the line means an image skyline above the DEM's.
    """
    residual = np.asarray(residual_px, float).ravel()
    known = np.isfinite(residual)
    title = say("Image skyline against DEM horizon")
    if not known.any():
        words = say("No column of the picture was compared with the DEM.")
        return figure(width, height, title, words, text(width / 2, height / 2, words, "name", "middle"))
    size = np.abs(residual[known])  # a run of outliers may leave the frame, so that the other columns stay visible
    half = max(1.4 * float(np.percentile(size, 90)), 4 * float(np.median(size)), 0.004 * (height_px or 0), 2.0)
    x = Scale(0, max(len(residual) - 1, 1), 44, width - (44 if pixels_per_degree else 10))
    y = Scale(half, -half, height - 34, 24)
    across, values = _bundled(residual)
    ys = np.clip(y(values), y.stop, y.start)
    parts = [text(4, 13, say("Skyline above DEM [px]")), *_residual_axes(half, pixels_per_degree, x, y)]
    parts.append(element("path", d=area_path(x(across), ys, float(y(0))), class_="residual-fill"))
    parts.append(line(x.start, float(y(0)), x.stop, float(y(0)), "zero"))
    parts.append(element("path", d=polyline_path(x(across), ys), class_="residual"))
    words = residuals_in_words(residual, height_px, pixels_per_degree, say)
    parts += [line(x.start, y.start, x.stop, y.start, "axis"), text(x.start, y.start + 16, say("left"))]
    parts.append(text(x.stop, y.start + 16, say("right"), anchor="end"))
    short = residuals_in_words(residual, None, pixels_per_degree, say)
    parts.append(text((x.start + x.stop) / 2, y.start + 16, short, "name", "middle"))
    return figure(width, height, title, say("Residuals along the columns: {words}.").format(words=words), *parts)


def residuals_in_words(residual_px, height_px=None, pixels_per_degree=None, say=str):
    """Describe the residuals in words: median of the absolute values, and the share of columns compared.

    Parameters
    ----------
    residual_px : array
        NaN where nothing was compared [pixels].
    height_px : float or None
        Height of the picture, for the median as a share of it [pixels].
    pixels_per_degree : float or None
        Scale used to give the median as an angle.
    say : callable
        Translates one English string.
    """
    residual = np.asarray(residual_px, float).ravel()
    known = np.isfinite(residual)
    if not known.any():
        return say("no column compared")
    median = float(np.median(np.abs(residual[known])))
    said = [say("median {value}").format(value=with_unit(median, "px", 1))]
    if is_known(pixels_per_degree):
        said.append(with_unit(median / pixels_per_degree, "°", 2, space=""))
    if height_px:
        said.append(say("{share} % of the height").format(share=f"{100 * median / height_px:.2f}"))
    compared = say("{share} % of columns").format(share=f"{100 * known.mean():.0f}")
    return f"{' = '.join(said)}; {compared}"


def _stepped(horizon):
    """Resample the profile to a regular half-degree circle, with the highest angle of each step, in drawing order."""
    count = round(360 / PROFILE_STEP_DEG)
    step = np.floor(wrap_360(np.asarray(horizon.azimuth_deg, float)) / PROFILE_STEP_DEG).astype(int) % count
    raw = np.asarray(horizon.elevation_deg, float)
    elevations, distances = np.full(count, np.nan), np.full(count, np.nan)
    order = np.argsort(np.where(np.isfinite(raw), raw, -np.inf), kind="stable")  # the highest is written last
    elevations[step[order]], distances[step[order]] = raw[order], np.asarray(horizon.distance_m, float)[order]
    clipped, void = np.zeros(count, bool), np.zeros(count, bool)
    np.logical_or.at(clipped, step, np.asarray(horizon.clipped, bool))
    np.logical_or.at(void, step, np.asarray(horizon.void, bool))
    azimuths = (np.arange(count) + 0.5) * PROFILE_STEP_DEG
    if len(raw) < count:  # a coarse profile leaves steps empty: join its points instead
        at = np.asarray(horizon.azimuth_deg, float)
        elevations = np.interp(azimuths, at, raw, period=360)
        nearest = np.rint(np.interp(azimuths, at, np.arange(len(at)))).astype(int)
        distances = np.asarray(horizon.distance_m, float)[nearest]
        clipped, void = np.asarray(horizon.clipped, bool)[nearest], np.asarray(horizon.void, bool)[nearest]
    return azimuths, elevations, distances, clipped, void


def _distance_areas(azimuths, elevations, distances, x, y):
    known = np.isfinite(elevations)
    colour = np.searchsorted(DISTANCE_STEPS_M, np.nan_to_num(distances), side="right")
    colour = np.where(known, colour, -1)
    half = PROFILE_STEP_DEG / 2
    paths = [""] * len(DISTANCE_LIGHT)
    for first, last in _runs_of_equal(colour):
        if colour[first] < 0:
            continue
        run = slice(first, last + 1)
        across = np.r_[azimuths[first] - half, azimuths[run], azimuths[last] + half]
        rise = elevations[run]
        paths[colour[first]] += area_path(x(across), y(np.r_[rise[0], rise, rise[-1]]), y.start)
    return [element("path", d=path, class_=f"far{index}") for index, path in enumerate(paths) if path]


def _angle_axis(x, y, say):
    parts = [text(4, 10, say("Elevation angle"))]
    for value in ticks(y.low, y.high, 4):
        at = float(y(value))
        class_ = "axis" if value == 0 else "grid"
        parts += [line(x.start, at, x.stop, at, class_), text(x.start - 5, at + 4, f"{value:g}°", anchor="end")]
    return "".join(parts)


def _azimuth_axis(x, y, say):
    parts = [line(x.start, y.start, x.stop, y.start, "axis")]
    for value in range(0, 361, 45):
        at = float(x(value))
        parts += [line(at, y.start, at, y.start + 4, "axis")]
        parts.append(text(at, y.start + 16, f"{compass_point(value, say)} {value}°", "name", "middle"))
    return "".join(parts)


def _view_span(heading_deg, hfov_deg, x, y):
    if not (is_known(heading_deg) and is_known(hfov_deg)):
        return []
    tall = y.start - y.stop
    parts = [
        element("rect", x=float(x(a)), y=y.stop, width=float(x(b) - x(a)), height=tall, class_="view")
        for a, b in spans_360(heading_deg - hfov_deg / 2, hfov_deg)
    ]
    at = float(x(wrap_360(heading_deg)))
    return [*parts, line(at, y.stop, at, y.start, "best"), text(at + 5, y.stop + 10, azimuth(heading_deg), "name-best")]


def _distance_key(x, height, say):
    title = say("Distance")
    parts, at = [text(x.start, height - 10, title)], x.start + 10 + 6 * len(title)
    steps = [f"{metres / 1000:g}" for metres in DISTANCE_STEPS_M]
    bounds = [f"<{steps[0]}", *(f"{near}–{far}" for near, far in zip(steps, steps[1:])), f">{steps[-1]} km"]
    for index, words in enumerate(bounds):
        parts.append(element("rect", x=at, y=height - 20, width=16, height=11, class_=f"far{index}"))
        parts.append(text(at + 20, height - 10, words))
        at += 36 + 6.2 * len(words)
    words = say("cut by the DEM's edge")
    parts.append(element("rect", x=at, y=height - 20, width=16, height=11, class_="clipped"))
    parts.append(text(at + 20, height - 10, words))
    at += 36 + 5.5 * len(words)
    parts.append(element("rect", x=at, y=height - 20, width=16, height=11, class_="unknown"))
    parts.append(text(at + 20, height - 10, say("void")))
    return parts


def _residual_axes(half, pixels_per_degree, x, y):
    parts = []
    for value in ticks(-half, half, 6):
        at = float(y(value))
        shown = with_unit(-value, "", 0 if half >= 4 else 1, signed=True)
        parts += [line(x.start, at, x.stop, at, "grid"), text(x.start - 5, at + 4, shown, anchor="end")]
    if pixels_per_degree:
        reach = half / pixels_per_degree
        parts += [
            text(x.stop + 5, float(y(-value * pixels_per_degree)) + 4, with_unit(value, "°", 2, True, ""))
            for value in ticks(-reach, reach, 6)
        ]
    return parts


def _bundled(residual):
    """Column positions and medians of at most `RESIDUAL_POINTS` groups of columns; NaN if no value is known."""
    group = -(-len(residual) // RESIDUAL_POINTS)
    padded = np.full(-(-len(residual) // group) * group, np.nan)
    padded[: len(residual)] = residual
    blocks = padded.reshape(-1, group)
    known = np.isfinite(blocks).any(axis=1)
    medians = np.full(len(blocks), np.nan)
    medians[known] = np.nanmedian(blocks[known], axis=1)
    return np.minimum((np.arange(len(blocks)) + 0.5) * group - 0.5, len(residual) - 1), medians


def _runs(mask):
    edges = np.flatnonzero(np.diff(np.r_[False, mask, False].astype(int)))
    return [(int(first), int(stop) - 1) for first, stop in zip(edges[::2], edges[1::2])]


def _runs_of_equal(values):
    starts = np.flatnonzero(np.r_[True, values[1:] != values[:-1]])
    return list(zip(starts.tolist(), (np.r_[starts[1:], len(values)] - 1).tolist()))


def _profile_in_words(horizon, say):
    elevation = np.asarray(horizon.elevation_deg, float)
    highest = int(np.nanargmax(elevation))
    return say(
        "The horizon is highest at azimuth {azimuth}: its elevation angle there is {angle} degrees and "
        "its distance {distance}. The median elevation angle is {median} degrees. In {share} % of the "
        "directions the DEM ends before higher terrain can be ruled out."
    ).format(
        azimuth=azimuth(horizon.azimuth_deg[highest]),
        angle=f"{elevation[highest]:.1f}",
        distance=with_unit(horizon.distance_m[highest] / 1000, "km", 1),
        median=f"{np.nanmedian(elevation):.1f}",
        share=f"{100 * np.mean(horizon.clipped):.0f}",
    )
