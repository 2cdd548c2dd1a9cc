"""How well photographs can be oriented at a place, before they are taken: predicted from the DEM, or simulated."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from .base.angles import difference
from .base.camera import Camera, Pose, focal_from_35mm_px, focal_of_fov_px
from .base.curvature import METRES_PER_DEGREE
from .base.model import HorizonProfile, OrientedPhoto, Photo, PhotoMetadata
from .base.progress import SILENT, subtask
from .batch import PhotoRequest, orient_request
from .eyes import HorizonCache
from .horizon.horizon import HorizonOptions, horizon_profile
from .locate.unique import Orientability, UniqueOptions, orientability
from .pipeline import OrientOptions
from .simulate.detail import DetailedTerrain
from .simulate.render import render_view
from .simulate.scene import SceneOptions
from .simulate.weather import hard_scene

WEATHERS = ("clear", "mixed", "season")
"""'clear' days; a 'season' of clouds, haze, trees, people and camera faults; 'mixed' is half of each."""

LONG_SIDE_PX, SHORT_SIDE_PX = 800, 600


@dataclass(frozen=True)
class PredictOptions:
    """Options of the prediction from the DEM.

    Attributes
    ----------
    horizon, unique : HorizonOptions, UniqueOptions
    """

    horizon: HorizonOptions = field(default_factory=lambda: HorizonOptions(0.5, 80_000.0))
    unique: UniqueOptions = field(default_factory=UniqueOptions)


def predict(dem, observer, hfovs_deg, options=PredictOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Predict how well photographs from a place could be oriented.

    Parameters
    ----------
    dem : Terrain
    observer : Observer
    hfovs_deg : sequence of float
        Horizontal fields of view [degrees].
    options : PredictOptions
    progress : Progress

    Returns
    -------
    horizon : HorizonProfile
    predictions : list of Orientability
        One for each field of view.

    Raises
    ------
    ObserverError
    """
    horizon: HorizonProfile = horizon_profile(dem, observer, options.horizon, progress)
    predictions: list[Orientability] = [
        orientability(horizon.elevation_deg, horizon.distance_m, hfov_deg, horizon.cell_m, options.unique)
        for hfov_deg in hfovs_deg
    ]
    return horizon, predictions


@dataclass(frozen=True)
class TrialOptions:
    """Photographs that are simulated.

    Attributes
    ----------
    weather : str
        One of `WEATHERS`.
    hfov_deg : (float, float)
        Narrowest and widest horizontal field of view [degrees].
    position_error_m : float
        Standard deviation of the recorded position in each direction [m].
    focal_error : float
        Largest error of the recorded focal length, as a share of it.
    roll_sigma_deg : float
        Spread of the roll [degrees].
    detail : float
        Roughness of the mountains that the DEM does not show; 0 photographs the DEM itself, which is too easy.
    seed : int
    orient : OrientOptions
    """

    weather: str = "season"
    hfov_deg: tuple = (40.0, 70.0)
    position_error_m: float = 6.0
    focal_error: float = 0.02
    roll_sigma_deg: float = 2.0
    detail: float = 0.22
    seed: int = 1
    orient: OrientOptions = field(default_factory=OrientOptions)

    def __post_init__(self):
        if self.weather not in WEATHERS or not 0 < self.hfov_deg[0] <= self.hfov_deg[1] < 150:
            raise ValueError(f"weather must be one of {WEATHERS}, and fields of view must lie below 150, not {self}")


@dataclass(frozen=True, eq=False)
class Trial:
    """One simulated photograph and its answer.

    Attributes
    ----------
    heading_deg, hfov_deg : float
        Truth [degrees].
    error_deg : float or None
        Heading found minus truth; None without an answer.
    covered : bool or None
        Whether the 90 % interval holds the truth.
    predicted : float
        Probability of a unique answer, predicted from the DEM.
    oriented : OrientedPhoto
    """

    heading_deg: float
    hfov_deg: float
    error_deg: float | None
    covered: bool | None
    predicted: float
    oriented: OrientedPhoto


def simulate_trial(dem, observer, number, options=TrialOptions(), progress=SILENT):  # noqa: B008 - frozen
    """Simulate a photograph at a place with random direction, lens, weather and errors, and orient it.

    Parameters
    ----------
    dem : core.io.raster.Dem or core.base.terrain.ArrayTerrain
    observer : Observer
        True position.
    number : int
        Number of the photograph; with the seed it fixes everything random.
    options : TrialOptions
    progress : Progress

    Returns
    -------
    Trial

    Raises
    ------
    PhotoError
        There is no usable horizon at this place.
    """
    random = np.random.Generator(np.random.PCG64([options.seed, number]))
    low, high = options.hfov_deg
    camera = Camera(LONG_SIDE_PX, SHORT_SIDE_PX, focal_of_fov_px(LONG_SIDE_PX, low + (high - low) * random.random()))
    horizon, (prediction,) = predict(dem, observer, (camera.hfov_deg,))
    heading = float(360 * random.random())
    pose = _pose(camera, horizon, heading, options.roll_sigma_deg, random)
    seed = int(random.integers(2**31))
    hard = options.weather == "season" or (options.weather == "mixed" and random.random() < 0.5)
    azimuth, height = 360 * random.random(), 15 + 45 * random.random()
    scene = hard_scene(seed) if hard else SceneOptions(seed, sun_azimuth_deg=azimuth, sun_elevation_deg=height)
    terrain = DetailedTerrain(dem, 3, options.seed, options.detail, sharpening=0.5) if options.detail > 0 else dem
    view = render_view(terrain, observer, camera, pose, scene, subtask(progress, 0.0, 0.5))
    photo = Photo(_metadata(observer, camera, number, options, random), view.pixels)
    request = PhotoRequest(photo.metadata.path, eye_height_m=observer.eye_height_m)
    oriented = orient_request(request, dem, options.orient, HorizonCache(), subtask(progress, 0.5, 1.0), photo)
    at = int(np.abs(difference(prediction.heading_deg, heading)).argmin())
    error_deg, covered = _errors(oriented, heading)
    return Trial(heading, camera.hfov_deg, error_deg, covered, float(prediction.probability[at]), oriented)


def _pose(camera, horizon, heading_deg, roll_sigma_deg, random):
    """A pose that places the skyline in the upper half of the picture."""
    inside = np.abs(difference(horizon.azimuth_deg, heading_deg)) < camera.hfov_deg / 2
    angles = horizon.elevation_deg[inside & np.isfinite(horizon.elevation_deg)]
    middle = float(np.median(angles)) if len(angles) else 0.0
    pitch = middle - camera.vfov_deg * (0.02 + 0.2 * random.random())
    roll = float(np.clip(roll_sigma_deg * random.standard_normal(), -8, 8))
    return Pose(heading_deg, float(np.clip(pitch, -60, 60)), roll)


def _metadata(observer, camera, number, options, random):
    east, north = options.position_error_m * random.standard_normal(2)
    scale = METRES_PER_DEGREE * np.cos(np.radians(observer.latitude_deg))
    f35 = camera.focal_px / focal_from_35mm_px(camera.width_px, camera.height_px, 1.0)
    return PhotoMetadata(
        f"simulated_{number + 1:04d}.jpg",
        camera.width_px,
        camera.height_px,
        latitude_deg=observer.latitude_deg + float(north) / METRES_PER_DEGREE,
        longitude_deg=observer.longitude_deg + float(east / scale),
        focal_length_35mm=float(f35 * (1 + options.focal_error * (2 * random.random() - 1))),
        position_error_m=max(options.position_error_m, 1.0),
    )


def _errors(oriented, heading_deg):
    if oriented.heading_deg is None:
        return None, None
    error = float(difference(oriented.heading_deg, heading_deg))
    interval = oriented.heading_interval_deg
    if interval is None:
        return error, None
    return error, bool((heading_deg - interval[0]) % 360 <= (interval[1] - interval[0]) % 360)


@dataclass(frozen=True)
class Expected:
    """Summary of simulated photographs.

    Attributes
    ----------
    photos, accepted : int
    within : tuple of (float, float)
        Limit [degrees], and share of the photographs whose heading is nearer to the truth.
    accepted_wrong : int
        Accepted photographs that are wrong by more than 3 degrees.
    median_deg : float or None
        Median error of the accepted ones [degrees].
    covered : float or None
        Share of the accepted ones whose 90 % interval holds the truth.
    """

    photos: int
    accepted: int
    within: tuple
    accepted_wrong: int
    median_deg: float | None
    covered: float | None


def summarise(trials, limits_deg=(0.5, 1.0, 3.0)):
    """Summarise trials as an `Expected`."""
    error = np.array([np.inf if trial.error_deg is None else abs(trial.error_deg) for trial in trials])
    accepted = np.array([trial.oriented.status == "accepted" for trial in trials], bool)
    held = [trial.covered for trial, sure in zip(trials, accepted) if sure and trial.covered is not None]
    return Expected(
        len(trials),
        int(accepted.sum()),
        tuple((limit, float((error < limit).mean())) for limit in limits_deg),
        int((accepted & (error > 3.0)).sum()),
        float(np.median(error[accepted])) if accepted.any() else None,
        float(np.mean(held)) if held else None,
    )
