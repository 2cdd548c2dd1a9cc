"""Change a pose by hand: hold a direction at a pixel, turn, zoom, level, and fit to a few landmarks.

Everything here is closed or a handful of projections, so that a drawn horizon follows the mouse at once.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ..base.angles import wrap_360
from ..base.camera import Camera, Pose, focal_of_fov_px, in_frame, project, unproject
from ..base.curvature import apparent_drop_m
from ..base.overlay_lines import HorizonLines, skyline_line

STEEPEST_DEG = 85.0
"""Largest pitch in either direction [degrees]."""

NARROWEST_DEG, WIDEST_DEG = 0.5, 150.0
"""Range of the horizontal field of view [degrees]."""

PITCH_SIGMA_DEG, ROLL_SIGMA_DEG = 20.0, 2.0
"""How far the pitch and the roll of a photograph taken by hand usually lie from the level [degrees]."""

LANDMARK_SIGMA_PX = 5.0
"""Precision of a click [pixels]."""

HAND_SHARE = 300.0
"""A person places a line to the picture's long side divided by this [pixels]."""


def aimed(camera, pose, direction_deg, pixel_px):
    """Turn heading and pitch, with the roll as it is, so that a direction appears at a pixel.

    Parameters
    ----------
    camera : Camera
    pose : Pose
    direction_deg : (float, float)
        True azimuth and elevation angle [degrees].
    pixel_px : (float, float)
        x and y in the full upright picture [pixels].

    Returns
    -------
    Pose
    """
    azimuth, elevation = direction_deg
    heading, pitch = pose.heading_deg, pose.pitch_deg
    for _ in range(12):  # pitch changes the elevation almost one to one
        seen_azimuth, seen_elevation = unproject(camera, Pose(heading, pitch, pose.roll_deg), *pixel_px)
        heading += azimuth - float(seen_azimuth)
        pitch = float(np.clip(pitch + elevation - float(seen_elevation), -STEEPEST_DEG, STEEPEST_DEG))
    return Pose(float(wrap_360(heading)), pitch, pose.roll_deg)


def dragged(camera, pose, from_px, to_px):
    """Move what is seen at one pixel to another, by heading and pitch.

    Parameters
    ----------
    camera : Camera
    pose : Pose
    from_px, to_px : (float, float)
        x and y in the full upright picture [pixels].

    Returns
    -------
    Pose
    """
    direction = unproject(camera, pose, *from_px)
    return aimed(camera, pose, (float(direction[0]), float(direction[1])), to_px)


def rolled(camera, pose, pivot_px, turn_deg):
    """Turn the horizon about a pixel.

    Parameters
    ----------
    camera : Camera
    pose : Pose
    pivot_px : (float, float)
        Pixel at which the direction stays the same [pixels].
    turn_deg : float
        Added to the roll, + if the horizon's right side climbs [degrees].

    Returns
    -------
    Pose
    """
    direction = unproject(camera, pose, *pivot_px)
    roll = float(np.mod(pose.roll_deg + turn_deg + 180.0, 360.0) - 180.0)
    turned = replace(pose, roll_deg=roll)
    return aimed(camera, turned, (float(direction[0]), float(direction[1])), pivot_px)


def turn_between_deg(pivot_px, from_px, to_px):
    """Angle by which a drag from one pixel to another turns the picture about a pivot, + anticlockwise [degrees].

    Parameters
    ----------
    pivot_px, from_px, to_px : (float, float)
        Pixels, y downwards.
    """
    (x0, y0), (x1, y1), (x2, y2) = pivot_px, from_px, to_px
    before, after = np.arctan2(y0 - y1, x1 - x0), np.arctan2(y0 - y2, x2 - x0)
    return float(np.degrees(np.angle(np.exp(1j * (after - before)))))


def zoomed(camera, pose, factor, pivot_px):
    """Multiply the focal length, and keep the direction at a pixel.

    Parameters
    ----------
    camera : Camera
    pose : Pose
    factor : float
        Of the focal length; the field of view stays within its limits.
    pivot_px : (float, float)
        Pixel at which the direction stays the same [pixels].

    Returns
    -------
    (Camera, Pose)
    """
    least, most = (focal_of_fov_px(camera.width_px, angle) for angle in (WIDEST_DEG, NARROWEST_DEG))
    direction = unproject(camera, pose, *pivot_px)
    changed = replace(camera, focal_px=float(np.clip(camera.focal_px * factor, least, most)))
    return changed, aimed(changed, pose, (float(direction[0]), float(direction[1])), pivot_px)


def levelled(camera, pose, horizon, skyline):
    """Change the pitch until the DEM's horizon lies on the extracted skyline, in the median over its columns.

    Parameters
    ----------
    camera : Camera
    pose : Pose
    horizon : HorizonProfile
    skyline : Skyline

    Returns
    -------
    Pose
        The same pose if horizon and skyline have no column in common.
    """
    line, lines = skyline_line(skyline, camera.width_px, camera.height_px), HorizonLines(horizon)
    for _ in range(6):
        shown = lines.line(camera, pose)
        known = np.isfinite(shown.x_px) & np.isfinite(shown.y_px)
        order = np.argsort(shown.x_px[known], kind="stable")
        if order.size < 2:
            return pose
        x, y = shown.x_px[known][order], shown.y_px[known][order]
        row = np.interp(line.x_px, x, y, left=np.nan, right=np.nan)
        miss = (line.y_px - row)[~line.doubtful]
        if not np.isfinite(miss).any():
            return pose
        turn = float(np.degrees(np.arctan(np.nanmedian(miss) / camera.focal_px)))
        pose = replace(pose, pitch_deg=float(np.clip(pose.pitch_deg + turn, -STEEPEST_DEG, STEEPEST_DEG)))
    return pose


def fitted_to_landmarks(camera, pose, landmarks, focal_sigma):
    """Fit heading, pitch, roll and focal length to landmarks, by least squares with weak priors.

    One landmark decides heading and pitch; a second one also the roll and, unless it is known, the focal length.

    Parameters
    ----------
    camera : Camera
        The focal length is what is assumed of it.
    pose : Pose
    landmarks : (N, 4) array
        x and y [pixels], and the true azimuth and elevation angle of the map point [degrees].
    focal_sigma : float
        Relative standard deviation of the focal length.

    Returns
    -------
    (Camera, Pose)
    """
    from scipy.optimize import least_squares

    x_px, y_px, azimuth, elevation = np.asarray(landmarks, float).reshape(-1, 4).T
    start = aimed(camera, replace(pose, roll_deg=0.0), (azimuth[0], elevation[0]), (x_px[0], y_px[0]))

    def unpacked(trial):
        turned = Pose(start.heading_deg + trial[0], start.pitch_deg + trial[1], trial[2])
        return replace(camera, focal_px=camera.focal_px * float(np.exp(np.clip(trial[3], -2, 2)))), turned

    def misses(trial):
        lens, turned = unpacked(trial)
        x, y = project(lens, turned, azimuth, elevation)
        off = np.concatenate([x - x_px, y - y_px]) / LANDMARK_SIGMA_PX
        priors = turned.pitch_deg / PITCH_SIGMA_DEG, trial[2] / ROLL_SIGMA_DEG, trial[3] / focal_sigma
        return np.concatenate([np.nan_to_num(off, nan=1e3), priors])

    trial = least_squares(misses, np.zeros(4), loss="soft_l1", f_scale=3.0).x
    lens, turned = unpacked(trial)
    return lens, replace(turned, heading_deg=float(wrap_360(turned.heading_deg)))


def horizon_marks(terrain, horizon, frame, camera, pose):
    """Give places of the map on the horizon and the pixels at which a camera shows them, as landmarks for the matcher.

    Parameters
    ----------
    terrain : Terrain
    horizon : HorizonProfile
    frame : LocalFrame
        Around the eye.
    camera : Camera
    pose : Pose

    Returns
    -------
    list of (x_px, y_px, longitude_deg, latitude_deg, elevation_m)
        About five, across the picture; empty if the picture shows no horizon.
    """
    azimuth, angle = np.asarray(horizon.azimuth_deg, float), np.asarray(horizon.elevation_deg, float)
    x, y = project(camera, pose, azimuth, angle)
    shown = np.flatnonzero(in_frame(camera, x, y) & np.isfinite(horizon.distance_m))
    marks: list[tuple[float, ...]] = []
    for share in (0.1, 0.3, 0.5, 0.7, 0.9):
        if not shown.size:
            break
        k = shown[np.abs(x[shown] - share * camera.width_px).argmin()]
        if any(mark[0] == float(x[k]) for mark in marks):
            continue
        far, turn = float(horizon.distance_m[k]), np.radians(azimuth[k])
        column, row = frame.to_pixel(far * np.sin(turn), far * np.cos(turn))
        height = horizon.eye_elevation_m + far * np.tan(np.radians(angle[k])) + apparent_drop_m(far)
        marks.append((float(x[k]), float(y[k]), *map(float, terrain.position_of(column, row)), float(height)))
    return marks


def hand_sigma_deg(camera):
    """Standard deviation of a direction that a person set by eye [degrees]."""
    long_side = max(camera.width_px, camera.height_px)
    return float(np.degrees(np.arctan(long_side / HAND_SHARE / camera.focal_px)))


def assumed_camera(width_px, height_px, hfov_deg=60.0):
    """Make the camera of a picture of unknown field of view, for a person to change.

    Parameters
    ----------
    width_px, height_px : int
        Size of the full upright picture [pixels].
    hfov_deg : float
        Horizontal field of view [degrees].
    """
    return Camera(width_px, height_px, focal_of_fov_px(width_px, hfov_deg))
