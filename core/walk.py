"""The offset of a camera's clock from the skylines of photographs along a track."""

from __future__ import annotations

from collections import OrderedDict

import numpy as np

from .base.blas import one_blas_thread
from .base.errors import MissingMetadataError, ObserverError, PhotoError
from .base.progress import SILENT, checkpoint, subtask
from .base.terrain import Observer
from .batch import PREVIEW_PX
from .horizon.horizon import HorizonOptions, horizon_profile
from .io.photo import read_photo
from .match.geometry import HorizonCurve
from .match.inputs import MatchInputs
from .match.likelihood import EvidenceStack
from .match.posterior import table
from .match.prior import camera_prior
from .match.search import SearchOptions, coarse_search
from .skyline.evidence import SkylineOptions, skyline_evidence
from .track.clock import ClockOptions, solve_clock
from .track.track import TrackOptions

CLOCK_HORIZON = HorizonOptions(azimuth_step_deg=0.2)
CLOCK_SEARCHES = (
    SearchOptions(step_deg=0.5, tolerance_deg=0.4, largest_roll_deg=5.0),
    SearchOptions(step_deg=0.25, tolerance_deg=0.2, largest_roll_deg=5.0),
)
"""Of the first, coarse search along the track, and of those after it."""
LEAST_COLUMNS = 0.3
"""Smallest share of columns with evidence for which a photograph helps to find the clock."""
KEPT_HORIZONS = 4_000


class SkylineFit:
    """How well the skylines of photographs fit the horizon of any place.

    Parameters
    ----------
    dem : Dem or ArrayTerrain
    eye_height_m : float
        Height of the eye above the DEM [m].
    """

    def __init__(self, dem, eye_height_m=1.7):
        self.dem, self.eye_height_m = dem, eye_height_m
        self._views, self._horizons = [], OrderedDict()

    def add(self, path, hfov_deg=None):
        """Read a photograph; return whether it shows a skyline that can help.

        Parameters
        ----------
        path : str
        hfov_deg : float or None
            Of the upright picture [degrees]; None takes the focal length in the file.
        """
        try:
            photo = read_photo(path, PREVIEW_PX)
            metadata = photo.metadata
            prior = camera_prior(metadata, hfov_deg)
            evidence = skyline_evidence(photo.pixels, SkylineOptions(), metadata.width_px, metadata.height_px)
        except (PhotoError, MissingMetadataError):
            return False
        informative = EvidenceStack.informative_columns(evidence.probability)
        if len(informative) < LEAST_COLUMNS * evidence.probability.shape[1]:
            return False
        stack = EvidenceStack(evidence.probability, leaves_frame=evidence.leaves_frame)
        camera = MatchInputs(evidence, prior, None).reduced_prior.camera  # type: ignore[arg-type]
        self._views.append((stack, camera))
        return True

    def __call__(self, number, place, level):
        """Log-likelihood of a photograph at a `Placed`, summed over the headings; None outside the DEM.

        Parameters
        ----------
        number : int
            Of the photograph, in the order in which `add` took them.
        place : Placed
        level : int
            Of the search: the first is the coarsest.
        """
        horizon = self._horizon(round(place.longitude_deg, 6), round(place.latitude_deg, 6))
        if horizon is None:
            return None
        stack, camera = self._views[number]
        with one_blas_thread():
            found = coarse_search(stack, camera, [horizon], CLOCK_SEARCHES[min(level, 1)])[0]
        value = table()["temperature"] * found.score
        return float(value.max() + np.log(np.mean(np.exp(value - value.max()))))

    def _horizon(self, longitude_deg, latitude_deg):
        key = longitude_deg, latitude_deg
        if key not in self._horizons:
            try:
                observer = Observer(longitude_deg, latitude_deg, self.eye_height_m)
                self._horizons[key] = HorizonCurve(horizon_profile(self.dem, observer, CLOCK_HORIZON))
            except ObserverError:
                self._horizons[key] = None
            while len(self._horizons) > KEPT_HORIZONS:
                self._horizons.popitem(last=False)
        return self._horizons[key]


# parameters: the photographs and what is known of them, which callers have as lists
def clock_from_skylines(
    paths, times_s, track, dem, options=ClockOptions(), track_options=TrackOptions(), progress=SILENT  # noqa: B008
):  # fmt: skip
    """Find how much the camera's clock is ahead, from the skylines of its photographs along a track.

    Parameters
    ----------
    paths : sequence of str
    times_s : sequence of float
        Times by the camera's clock as if it were right [s since 1970, UTC].
    track : Track
    dem : Dem or ArrayTerrain
    options : ClockOptions
    track_options : TrackOptions
    progress : Progress

    Returns
    -------
    ClockAnswer

    Raises
    ------
    Cancelled
    """
    fit = SkylineFit(dem)
    times: list = []
    # Reading the skyline takes longest, so only as many photographs as the search takes are read, spread over the walk.
    order, stride = np.argsort(times_s, kind="stable"), max(-(-len(times_s) // options.photos), 1)
    spread = np.concatenate([order[start::stride] for start in range(stride)])
    for count, index in enumerate(spread):
        if len(times) == options.photos:
            break
        checkpoint(progress, 0.2 * count / len(spread))
        if fit.add(paths[index]):
            times.append(float(times_s[index]))
    checkpoint(progress, 0.2)
    return solve_clock(times, track, fit, options, track_options, subtask(progress, 0.2, 1.0))
