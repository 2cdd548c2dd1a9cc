"""The vocabulary: values that cross from one stage to another.

Angles are degrees, lengths metres, pixels floats with the centre of the first pixel at 0. None means unknown;
nothing here is ever made up to fill a gap.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from datetime import datetime

import numpy as np

from .answer import PhotoAnswer
from .camera import FOCAL_SIGMA, Camera, Pose
from .messages import Message


@dataclass(frozen=True)
class PhotoMetadata:
    """What a photograph's file says about itself.

    Attributes
    ----------
    path : str
    width_px, height_px : int
        Of the *upright* picture [pixels].
    latitude_deg, longitude_deg : float or None
        WGS 84 [degrees].
    altitude_m : float or None
        GPSAltitude, negative below the sea [m].
    altitude_reference : str or None
        'sea level', 'below sea level', 'ellipsoid' as GPSAltitudeRef says.
    focal_length_35mm, focal_length_mm : float or None
        35 mm equivalent of the picture as it is, and the lens's real focal length [mm].
    focal_sigma : float
        Relative spread of the equivalent.
    orientation : int
        EXIF Orientation 1 to 8, for the record; pixels and sizes here are upright already.
    compass_heading_deg : float or None
        GPSImgDirection as recorded [degrees].
    compass_reference : str or None
        'T' true, 'M' magnetic, None unknown.
    position_error_m : float or None
        GPSHPositioningError [m].
    taken_at : datetime or None
        Camera's local time.
    camera : str or None
        Maker and model.
    notes : tuple of Message
        Remarks worth telling the user (coordinates ignored and why, a focal length that was derived, ...).
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


@dataclass(frozen=True, eq=False)
class Photo:
    """A photograph: metadata and upright pixels, uint8 (H, W, 3) RGB.

    The pixels may be a reduced copy; `metadata.width_px, height_px` always give the full size.
    """

    metadata: PhotoMetadata
    pixels: np.ndarray


@dataclass(frozen=True, eq=False)
class Skyline:
    """One boundary row per column of a picture of `width_px` x `height_px`.

    Attributes
    ----------
    row_px : (W,) array
        Row of the first terrain pixel [pixels].
    confidence : (W,) array
        0 to 1; 0 where no believable boundary was found (then `row_px` is only an interpolation).
    """

    row_px: np.ndarray
    confidence: np.ndarray
    width_px: int
    height_px: int

    @property
    def valid(self) -> np.ndarray:
        """(W,) bool: columns with a believable boundary."""
        return self.confidence > 0


@dataclass(frozen=True, eq=False)
class SkylineEvidence:
    """Where the skyline may be, as a probability over rows for each column of a reduced picture.

    Attributes
    ----------
    probability : (h, w) float32 array
        p(first terrain row = y | column); each column sums to 1, less its `leaves_frame`. A column without
        information is flat.
    best : Skyline
        The single most likely continuous line, on the reduced picture (for drawing and for the table).
    width_px, height_px : int
        Size of the upright full picture [pixels]; the reduced one has `probability.shape`.
    crop : (top, bottom, left, right) ints
        Rows and columns of the reduced picture cut off as border or caption; the probabilities are flat there.
    sky_score : (h, w) float32 array or None
        Log-likelihood ratio sky against ground per pixel, clipped, for reports and cloud handling.
    ridge_score : (h, w) float32 array or None
        Evidence of an interior ridge (occlusion edge) per pixel, 0 or more, for second evidence.
    leaves_frame : (w,) float32 array or None
        Probability that terrain fills the column, so that its skyline lies above the picture; None: nowhere.
    thumbnail : (h', w', 3) float32 array or None
        The picture itself, RGB 0 to 255, much reduced and NaN where it was cut off, for second evidence.
    rival : SkylineEvidence or None
        The same if the best line is a crest before farther terrain: what there is above it. None where that is little.
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
    rival: SkylineEvidence | None = None


@dataclass(frozen=True)
class Candidate:
    """One distinct answer: pose, lens, and how well it explains the picture (higher is better)."""

    pose: Pose
    camera: Camera
    score: float
    probability: float | None = None


@dataclass(frozen=True, eq=False)
class Orientation:
    """The answer for one photograph.

    Attributes
    ----------
    status : str
        'accepted', 'ambiguous', 'rejected' ('failed' is for input faults and never comes from a matcher).
    message : Message
        Why, and what to do, in a plain sentence.
    candidates : tuple of Candidate
        Distinct answers, best first; empty when nothing could be matched.
    heading_lo_deg, heading_hi_deg : float or None
        90 % interval of the true heading, clockwise from lo to hi [degrees].
    p_correct : float or None
        Probability that the heading is within 3 degrees of the truth.
    curve_heading_deg, curve_score : (N,) arrays
        The score over the whole circle, for curve and rose.
    ncc, ncc_second, sharpness : float or None
        Normalised cross-correlation of image and DEM skyline at the answer, the second peak's, and the peak's
        sharpness as the paper's method has them.
    residual_px : (w,) array or None
        Image skyline minus projected horizon along the columns of the reduced picture [pixels of the full picture].
    notes : tuple of Message
        Remarks worth telling the user (eye height disagreement, clipped horizon, ...).
    behind : bool
        The horizon was matched with the evidence's rival.
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

    @property
    def best(self) -> Candidate | None:
        """The first candidate, or None."""
        return self.candidates[0] if self.candidates else None


@dataclass(frozen=True, eq=False, repr=False)
class OrientedPhoto(PhotoAnswer):
    """Everything a run learned about one photograph: what shells write to attributes and what the report draws.

    Attributes
    ----------
    path : str
    orientation : Orientation
        With status 'failed' and the reason where an input fault stopped it; then most of the rest is None.
    metadata : PhotoMetadata or None
    preview : uint8 (h, w, 3) array or None
        Upright reduced picture for figures.
    camera : Camera or None
        Of the full upright picture: the fitted one where a heading was found, else the prior.
    skyline : Skyline or None
        As extracted, on a picture of `skyline.width_px` x `skyline.height_px`.
    evidence : SkylineEvidence or None
        Robust method only.
    horizon : HorizonProfile or None
    longitude_deg, latitude_deg : float or None
        Position used, WGS 84 [degrees].
    eye_elevation_m : float or None
        Absolute elevation of the eye used [m].
    ground_elevation_m : float or None
        Of the DEM under the observer [m].
    convergence_deg : float or None
        Bearing of the DEM's grid north from true north, clockwise [degrees].
    compass_true_deg : float or None
        Recorded heading turned to true north [degrees].
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
    """The sky-terrain boundary as the DEM has it, around one observer.

    Attributes
    ----------
    azimuth_deg : (A,) array
        Regular, from 0, clockwise from true north [degrees].
    elevation_deg : (A,) array
        Elevation angle of the horizon [degrees]; NaN where nothing is known in that direction.
    distance_m : (A,) array
        Ground distance of the horizon point [m]; NaN where unknown.
    clipped : (A,) bool array
        The DEM ends in this direction before `max_distance_m` and terrain beyond its edge could be higher, so that
        the horizon is a lower bound.
    void : (A,) bool array
        Cells without data lie along the ray and might hide a higher horizon.
    eye_elevation_m : float
        Of the observer's eye [m].
    cell_m : float
        Ground size of the DEM's cells [m].
    reach_m : (A,) array
        How far the DEM was searched in each direction [m].
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
