"""Values that the stages of the program exchange.

Angles are in degrees and lengths in metres. Pixel coordinates are floats with the centre of the first pixel at 0. None
means unknown; a missing value is never replaced by an invented one.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from datetime import datetime

import numpy as np

from .answer import PhotoAnswer
from .camera import FOCAL_SIGMA, Camera, Pose
from .uncertainty import PoseUncertainty


@dataclass(frozen=True)
class PhotoMetadata:
    """Metadata read from a photograph's file.

    Attributes
    ----------
    path : str
    width_px, height_px : int
        Size of the *upright* picture [pixels].
    latitude_deg, longitude_deg : float or None
    altitude_m, altitude_reference : float or None, str or None
        GPSAltitude, negative below the sea [m]; 'sea level', 'below sea level' or 'ellipsoid', from GPSAltitudeRef.
    focal_length_35mm, focal_length_mm : float or None
        35 mm equivalent of the picture in its present crop, and the real focal length of the lens [mm].
    focal_sigma : float
        Relative standard deviation of the 35 mm equivalent [1].
    orientation : int
        EXIF Orientation 1 to 8, for information only; pixels and sizes here are already upright.
    compass_heading_deg, compass_reference : float or None, str or None
        GPSImgDirection, or else a drone's yaw, clockwise [degrees] from 'T', true north, or 'M', magnetic north.
    position_error_m : float or None
    taken_at, utc_offset_s : datetime or None, float or None
        Local time of the camera, and how much it is ahead of UTC [s], as recorded or from the time of the GPS.
    camera, make, model, lens, software : str or None
        Maker and model for people; maker, model and lens as the file has them; what wrote it (on phones, the system).
    notes : tuple of Message
        Remarks for the user (why coordinates were ignored, a focal length that was derived, ...).
    panorama : bool
        Whether the picture is stitched, so that no pinhole camera describes it.
    gimbal_pitch_deg, gimbal_roll_deg : float or None
        As a drone records them, for information only [degrees].
    """

    path: str
    width_px: int
    height_px: int
    latitude_deg: float | None = None
    longitude_deg: float | None = None
    altitude_m: float | None = None
    altitude_reference: str | None = None
    focal_length_35mm: float | None = None
    focal_length_mm: float | None = None
    focal_sigma: float = FOCAL_SIGMA
    orientation: int = 1
    compass_heading_deg: float | None = None
    compass_reference: str | None = None
    position_error_m: float | None = None
    taken_at: datetime | None = None
    camera: str | None = None
    notes: tuple[str, ...] = ()
    panorama: bool = False
    utc_offset_s: float | None = None
    gimbal_pitch_deg: float | None = None
    gimbal_roll_deg: float | None = None
    software: str | None = None
    make: str | None = None
    model: str | None = None
    lens: str | None = None


@dataclass(frozen=True, eq=False)
class Photo:
    """A photograph: metadata (always those of the full size), and upright uint8 (H, W, 3) RGB pixels of any size."""

    metadata: PhotoMetadata
    pixels: np.ndarray


@dataclass(frozen=True, eq=False)
class Skyline:
    """Skyline as one boundary row per column of a picture of `width_px` x `height_px`.

    Attributes
    ----------
    row_px : (W,) array
        Row of the first terrain pixel [pixels].
    confidence : (W,) array
        0 to 1; 0 where no plausible boundary was found (`row_px` is only an interpolation there).
    """

    row_px: np.ndarray
    confidence: np.ndarray
    width_px: int
    height_px: int

    @property
    def valid(self) -> np.ndarray:
        """Columns with a plausible boundary, (W,) bool."""
        return self.confidence > 0


@dataclass(frozen=True, eq=False)
class SkylineEvidence:
    """Probability of the skyline over the rows of each column of a reduced picture.

    Attributes
    ----------
    probability : (h, w) float32 array
        p(first terrain row = y | column), flat without information; each column sums to 1 minus its `leaves_frame`.
    best : Skyline
        The most likely continuous line on the reduced picture, for drawing and for the table.
    width_px, height_px : int
        Size of the upright full picture [pixels]; the reduced one has `probability.shape`.
    crop : (top, bottom, left, right) ints
        Rows and columns of the reduced picture excluded as border or caption; the probabilities are flat there.
    sky_score : (h, w) float32 array or None
        Clipped log-likelihood ratio of sky to ground per pixel, for reports and cloud handling.
    ridge_score : (h, w) float32 array or None
        Evidence of an interior ridge (occlusion edge) per pixel, 0 or more; used as second evidence.
    leaves_frame : (w,) float32 array or None
        Probability that terrain fills the column, so that its skyline lies above the picture; None if 0 everywhere.
    thumbnail : (h', w', 3) float32 array or None
        Strongly reduced picture, RGB 0 to 255, NaN where it was excluded; used as second evidence.
    sky_map : (h', w') float32 array or None
        Probability of sky by the sky network, NaN where the picture was excluded; used as second evidence.
    rival : SkylineEvidence or None
        Evidence above the best line, in case that line is a crest before farther terrain; None if there is little.
    """

    probability: np.ndarray
    best: Skyline
    width_px: int
    height_px: int
    crop: tuple[int, int, int, int] = (0, 0, 0, 0)
    sky_score: np.ndarray | None = None
    ridge_score: np.ndarray | None = None
    leaves_frame: np.ndarray | None = None
    thumbnail: np.ndarray | None = None
    sky_map: np.ndarray | None = None
    rival: SkylineEvidence | None = None


@dataclass(frozen=True)
class Candidate:
    """One distinct answer: pose, camera, score (higher is better), and the heading's spread if the answer is right."""

    pose: Pose
    camera: Camera
    score: float
    probability: float | None = None
    heading_sigma_deg: float | None = None


@dataclass(frozen=True, eq=False)
class Orientation:
    """The answer for one photograph.

    Attributes
    ----------
    status : str
        'accepted', 'ambiguous' or 'rejected'; 'failed' is for faulty input and never comes from a matcher.
    message : Message or str
        The reason for the status, and what the user can do, in a plain sentence.
    candidates : tuple of Candidate
        Distinct answers, best first; empty if nothing could be matched.
    heading_lo_deg, heading_hi_deg : float or None
        90 % interval of the true heading, clockwise from lo to hi [degrees].
    p_correct : float or None
        Probability that the heading is within 3 degrees of the truth.
    curve_heading_deg, curve_score : (N,) arrays
        Headings over the whole circle [degrees] and the score at each, for curve and rose diagrams.
    ncc, ncc_second, sharpness : float or None
        Correlation of image and DEM skyline at the answer and the second peak, and sharpness, as in the paper.
    residual_px : (w,) array or None
        Image skyline minus projected horizon along the columns of the reduced picture [pixels of the full picture].
    notes : tuple of Message or str
        Remarks for the user (disagreement of eye heights, clipped horizon, ...); a plain str is not translated.
    behind : bool
        Whether the horizon was matched with the `rival` of the evidence.
    eye : int
        Which hypothesis of the eye's elevation the best answer belongs to; 0 is the assumed one.
    uncertainty : PoseUncertainty or None
        Of the best answer's pitch, roll and focal length.
    """

    status: str
    message: str
    candidates: tuple[Candidate, ...] = ()
    heading_lo_deg: float | None = None
    heading_hi_deg: float | None = None
    p_correct: float | None = None
    curve_heading_deg: np.ndarray = field(default_factory=lambda: np.zeros(0))
    curve_score: np.ndarray = field(default_factory=lambda: np.zeros(0))
    ncc: float | None = None
    ncc_second: float | None = None
    sharpness: float | None = None
    residual_px: np.ndarray | None = None
    notes: tuple[str, ...] = ()
    behind: bool = False
    eye: int = 0
    uncertainty: PoseUncertainty | None = None

    @property
    def best(self) -> Candidate | None:
        """First candidate, or None."""
        return self.candidates[0] if self.candidates else None


@dataclass(frozen=True, eq=False, repr=False)
class OrientedPhoto(PhotoAnswer):
    """Everything that a run found for one photograph, for attribute tables and reports.

    Attributes
    ----------
    path : str
    orientation : Orientation
        Has status 'failed' and the reason if faulty input stopped the run; most other attributes are None then.
    metadata : PhotoMetadata or None
    preview : uint8 (h, w, 3) array or None
        Reduced upright picture for figures.
    camera : Camera or None
        Camera of the full upright picture: the fitted one if a heading was found, otherwise the prior.
    skyline : Skyline or None
        Extracted skyline, on a picture of `skyline.width_px` x `skyline.height_px`.
    evidence, horizon : SkylineEvidence or None, HorizonProfile or None
        The robust method alone gives evidence.
    longitude_deg, latitude_deg : float or None
        WGS 84 position that was used [degrees].
    eye_elevation_m, ground_elevation_m : float or None
        Absolute elevation of the eye that was used, and of the DEM at the observer [m].
    convergence_deg : float or None
        Bearing of the DEM's grid north from true north, clockwise positive [degrees].
    compass_true_deg : float or None
        Recorded heading, converted to true north [degrees].
    """

    path: str
    orientation: Orientation
    metadata: PhotoMetadata | None = None
    preview: np.ndarray | None = None
    camera: Camera | None = None
    skyline: Skyline | None = None
    evidence: SkylineEvidence | None = None
    horizon: HorizonProfile | None = None
    longitude_deg: float | None = None
    latitude_deg: float | None = None
    eye_elevation_m: float | None = None
    ground_elevation_m: float | None = None
    convergence_deg: float | None = None
    compass_true_deg: float | None = None


@dataclass(frozen=True, eq=False)
class HorizonProfile:
    """Horizon of a DEM around one observer: the boundary between sky and terrain.

    Attributes
    ----------
    azimuth_deg : (A,) array
        Regularly spaced azimuths from 0, clockwise from true north [degrees].
    elevation_deg, distance_m : (A,) arrays
        Elevation angle of the horizon, up positive [degrees], and ground distance of its point [m]; NaN where unknown.
    clipped : (A,) bool array
        The horizon is a lower bound: the DEM ends before `max_distance_m`, and terrain beyond could be higher.
    void : (A,) bool array
        True where cells without data lie along the ray and may contain a higher horizon.
    eye_elevation_m, cell_m : float
        Elevation of the observer's eye, and size of the DEM's cells on the ground [m].
    reach_m : (A,) array
        Distance to which the DEM was searched in each direction [m].
    """

    azimuth_deg: np.ndarray
    elevation_deg: np.ndarray
    distance_m: np.ndarray
    clipped: np.ndarray
    void: np.ndarray
    eye_elevation_m: float
    cell_m: float
    reach_m: np.ndarray

    def __repr__(self) -> str:
        known = np.isfinite(self.elevation_deg)
        facts = [f"{len(self.azimuth_deg)} azimuths, eye at {self.eye_elevation_m:.0f} m"]
        if known.any():
            elevation, distance = self.elevation_deg[known], self.distance_m[known]
            facts.append(f"horizon at {elevation.min():.2f}° to {elevation.max():.2f}°")
            facts.append(f"{distance.min() / 1000:.1f} to {distance.max() / 1000:.1f} km away")
        if not known.all() or self.clipped.any() or self.void.any():
            unsure = float(np.mean(~known | self.clipped | self.void))
            facts.append(f"DEM too small or with voids in {100 * unsure:.0f} % of the directions")
        return f"<HorizonProfile: {', '.join(facts)}>"
