"""Orient one photograph file; QGIS algorithms, benchmarks and scripts all use this entry.

The module reads the file, determines position, lens and eye, shares horizons between photographs from one station, and
turns every error in a photograph into an answer with status 'failed' and a message. Errors in the DEM stop the batch.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from .base import imaging
from .base.blas import one_blas_thread
from .base.camera import FOCAL_SIGMA, folds
from .base.declination import declination_deg
from .base.doubt import doubted, position_doubt
from .base.errors import MissingMetadataError, MissingPackageError, PhotoError
from .base.heights import altitude_limit_m, contradiction, doubt_of_run, eye_notes
from .base.messages import Message
from .base.model import Orientation, OrientedPhoto
from .base.place import position_error_of, position_of
from .base.progress import SILENT, subtask
from .base.terrain import Observer, ground_elevation_m
from .eyes import HorizonCache, other_eyes
from .io.photo import read_metadata, read_photo
from .match.landmarks import Landmark
from .match.prior import CompassOptions, HeadingPrior, camera_prior, compass_prior, true_heading_deg
from .pipeline import Hints, OrientOptions, Setting, orient_photo
from .skyline.given import evidence_from_line, evidence_from_mask

PREVIEW_PX = 1024
"""Long side of the pictures that the robust method and the figures use [pixels]; the evidence itself uses 512."""

DISTRUSTED_NOTE = Message(
    "In other photos of this run, the compass of this camera often contradicts the skyline, so its reading counts for "
    "less."
)


@dataclass(frozen=True)
class PhotoRequest:
    """One photograph and what is known apart from its file; None means the value from the file or the DEM.

    Attributes
    ----------
    path : str
    longitude_deg, latitude_deg : float or None
        Position, WGS 84 [degrees]; 0, 0 counts as no position.
    prefer_photo_position : bool
        Use the position in the file if it has one, and the given position otherwise.
    eye_elevation_m : float or None
        Absolute elevation of the eye in the DEM's height system [m].
    eye_height_m : float
        Height of the eye above the DEM, used if no elevation is given [m].
    use_altitude : bool
        Put the eye at the altitude recorded in the file if no elevation is given.
    hfov_deg : float or None
        Horizontal field of view of the upright picture [degrees].
    focal_length_35mm : float or None
        Overrides the value in the file [mm].
    k1, k2 : float
        Radial distortion of the lens; see `Camera`.
    position_error_m : float or None
        Standard deviation of the position [m].
    heading_deg, heading_tolerance_deg : float or None, float
        Approximate true heading, and the largest plausible error of it [degrees].
    landmarks : tuple of LandmarkHint
    drawn_skyline : tuple of (x_px, y_px) or None
        Vertices on the full upright picture.
    sky_mask_path : str or None
        Picture in which the sky is white.
    """

    path: str
    longitude_deg: float | None = None
    latitude_deg: float | None = None
    prefer_photo_position: bool = False
    eye_elevation_m: float | None = None
    eye_height_m: float = 1.7
    use_altitude: bool = False
    hfov_deg: float | None = None
    focal_length_35mm: float | None = None
    k1: float = 0.0
    k2: float = 0.0
    position_error_m: float | None = None
    heading_deg: float | None = None
    heading_tolerance_deg: float = 20.0
    landmarks: tuple = ()
    drawn_skyline: tuple | None = None
    sky_mask_path: str | None = None


def orient_request(request, dem, options=OrientOptions(), cache=None, progress=SILENT, photo=None):  # noqa: B008 - frozen
    """Orient one photograph.

    Parameters
    ----------
    request : PhotoRequest
    dem : core.io.raster.Dem or core.base.terrain.ArrayTerrain
    options : OrientOptions
    cache, progress : HorizonCache or None, Progress
    photo : core.base.model.Photo or None
        In memory; None reads the file.

    Returns
    -------
    OrientedPhoto
        Status 'failed' with the reason if there is an error in the photograph or its data.

    Raises
    ------
    TerrainError
        The DEM as a whole cannot be used.
    """
    try:
        with one_blas_thread():
            if photo is None:
                photo = read_photo(request.path, None if options.method == "paper" else PREVIEW_PX)
            return _orient(request, photo, dem, options, cache or HorizonCache(), progress)
    except (PhotoError, MissingPackageError) as error:
        return OrientedPhoto(request.path, Orientation("failed", error.message))


def _orient(request, photo, dem, options, cache, progress):
    paper = options.method == "paper"
    if photo.metadata.panorama and request.hfov_deg is None and request.focal_length_35mm is None:
        raise MissingMetadataError(
            Message(
                "The photo is a stitched panorama, which is not the picture of one lens. Use a single photo, or give "
                "the horizontal field of view in HFOV_FIELD if the panorama is rectilinear."
            )
        )
    if request.focal_length_35mm is not None:
        lens = {"focal_length_35mm": request.focal_length_35mm, "focal_sigma": FOCAL_SIGMA}
        photo = replace(photo, metadata=replace(photo.metadata, **lens))
    metadata = photo.metadata
    longitude, latitude = position_of(request, metadata)
    error = position_error_of(request, metadata)
    observer = Observer(longitude, latitude, request.eye_height_m, _eye_elevation_m(request, metadata))
    prior = camera_prior(metadata, request.hfov_deg)
    prior = replace(prior, camera=_distorted(prior.camera, request.k1, request.k2))
    compass = recorded_heading_deg(metadata, longitude, latitude)
    share = dict(options.compass_shares).get(metadata.camera, CompassOptions.outlier_share)
    reading = compass if options.compass == "prior" else None
    believed = compass_prior(reading, CompassOptions().with_outliers(share))
    hints = _hints(request, metadata, dem, observer, believed)
    if hints.heading is None:
        hints = replace(hints, recorded_heading_deg=compass)
    inner, eyes = None, ()
    with cache.station():
        horizon = cache.profile(dem, observer, options.horizon_of_method, subtask(progress, 0.1, 0.4))
        if not paper:
            inner = cache.inner(dem, observer, options.inner)
            eyes = other_eyes(dem, observer, horizon, metadata.altitude_m, options, cache)
    setting = Setting(observer, prior, hints, horizon, inner, error, eyes)
    oriented = orient_photo(photo, dem, setting, options, subtask(progress, 0.4, 1.0))
    notes = metadata.notes + eye_notes(request, metadata, oriented) + oriented.orientation.notes
    used = believed is not None and hints.heading is believed and not paper
    if used and share > CompassOptions.outlier_share:
        notes += (DISTRUSTED_NOTE,)
    limit_m = altitude_limit_m(metadata, horizon.cell_m, options.eyes.largest_altitude_error_m, error)
    answer = doubted(
        replace(oriented.orientation, notes=notes), position_doubt(oriented.orientation, error), keep_interval=True
    )
    return replace(
        oriented,
        orientation=doubted(answer, contradiction(request, metadata, oriented, limit_m)),
        preview=np.rint(imaging.shrink_to(photo.pixels, PREVIEW_PX)).astype(np.uint8),
        compass_true_deg=compass,
    )


def _distorted(camera, k1, k2):
    """Camera with the lens's distortion, which must not fold the picture."""
    camera = replace(camera, k1=float(k1), k2=float(k2))
    if folds(camera):
        raise PhotoError(
            Message(
                "A lens with k1 = {k1} and k2 = {k2} would fold the picture before its corner. Correct k1 and k2: they "
                "are those of OpenCV, for radii in focal lengths.",
                k1=f"{k1:g}",
                k2=f"{k2:g}",
            )
        )
    return camera


def doubt_of_heights(requests, dem, most=40):
    """Compare the recorded altitudes of some photographs with the DEM before a run.

    Parameters
    ----------
    requests : sequence of PhotoRequest
    dem : core.io.raster.Dem or core.base.terrain.ArrayTerrain
    most : int
        Largest number of photographs that are opened for it.

    Returns
    -------
    Message or None
        What is likely wrong, if the median difference is no error of GPS receivers.
    """
    altitudes, grounds = [], []
    for request in requests[:: max(-(-len(requests) // most), 1)]:
        try:
            metadata = read_metadata(request.path)
            longitude, latitude = position_of(request, metadata)
            ground = ground_elevation_m(dem, dem.frame(longitude, latitude, 1_000.0))
        except PhotoError:
            continue
        if metadata.altitude_m is not None:
            altitudes.append(metadata.altitude_m)
            grounds.append(ground)
    return doubt_of_run(altitudes, grounds)


def recorded_heading_deg(metadata, longitude_deg, latitude_deg):
    """Recorded heading against true north at a position [degrees]; None if there is none or it cannot be converted.

    Parameters
    ----------
    metadata : PhotoMetadata
    longitude_deg, latitude_deg : float
        WGS 84, for the declination [degrees].
    """
    return true_heading_deg(metadata, _declination(metadata, longitude_deg, latitude_deg))


def _declination(metadata, longitude_deg, latitude_deg):
    """Declination at the photo's place and time; None if it cannot be determined."""
    if metadata.compass_reference != "M" or metadata.taken_at is None:
        return None
    return declination_deg(latitude_deg, longitude_deg, metadata.altitude_m or 0.0, metadata.taken_at)


def _hints(request, metadata, dem, observer, compass):
    if request.heading_deg is not None:
        # The tolerance that a person gives counts as two standard deviations.
        heading = HeadingPrior(float(request.heading_deg), max(request.heading_tolerance_deg / 2, 0.5), 0.01)
    else:
        heading = compass
    size = metadata.width_px, metadata.height_px
    evidence = None
    if request.drawn_skyline is not None:
        x_px, y_px = np.asarray(request.drawn_skyline, float).reshape(-1, 2).T
        _check_drawn(x_px / size[0], y_px / size[1], size)
        evidence = evidence_from_line(x_px, y_px, *size)
    elif request.sky_mask_path is not None:
        evidence = evidence_from_mask(read_photo(request.sky_mask_path, PREVIEW_PX).pixels, *size)
    landmarks = tuple(_landmark(hint, hint.direction_deg(dem, observer, metadata)) for hint in request.landmarks)
    return Hints(heading, landmarks, evidence)


def _landmark(hint, direction_deg):
    azimuth, elevation = direction_deg
    return Landmark(hint.x_px, hint.y_px, azimuth, elevation, hint.sigma_px)


def _check_drawn(across, down, size):
    """Raise `PhotoError` for a skyline on another copy of the picture; hands slip a little over the edge."""
    if across.max(initial=0) > 1.05 or across.min(initial=0) < -0.05 or down.max(initial=0) > 1.05:
        raise PhotoError(
            Message(
                "The drawn skyline reaches beyond the picture of {width} x {height} pixels. Draw it on this picture, "
                "not on a reduced or turned copy.",
                width=size[0],
                height=size[1],
            )
        )


def _eye_elevation_m(request, metadata):
    """Elevation of the eye that was given, or recorded and to be used; None means that of the DEM."""
    if request.eye_elevation_m is not None or not request.use_altitude:
        return request.eye_elevation_m
    # DEM elevations are above sea level, and the geoid lies up to 100 m from the ellipsoid; `base.heights` tells of 0.
    return None if metadata.altitude_reference == "ellipsoid" else metadata.altitude_m or None
