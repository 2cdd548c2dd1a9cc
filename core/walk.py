"""The offset of a camera's clock from the skylines of photographs along a track."""

from __future__ import annotations

from collections import OrderedDict

import numpy as np

from .base.blas import one_blas_thread
from .base.errors import MissingMetadataError, ObserverError, PhotoError
from .base.progress import SILENT, checkpoint, subtask
from .base.terrain import Observer, eye_elevation_m
from .batch import PREVIEW_PX
from .horizon.horizon import HorizonOptions, horizon_from
from .horizon.surroundings import Surroundings
from .io.photo import read_photo
from .locate.fit import best_over_scales, curves_of
from .match.geometry import HorizonCurve
from .match.inputs import eye_offsets_m
from .match.likelihood import EvidenceStack
from .match.posterior import table
from .match.prior import camera_prior
from .match.robust import skyline_relief_deg
from .match.search import SearchOptions, coarse_search
from .searching import SkylineProblem
from .skyline.evidence import SkylineOptions, skyline_evidence
from .skyline.plausible import check_skyline
from .track.clock import ClockOptions, solve_clock, spread_over_walk
from .track.offsets import COARSE
from .track.track import TrackOptions

CLOCK_HORIZON = HorizonOptions(azimuth_step_deg=0.2)
CLOCK_SEARCH = SearchOptions(step_deg=0.5, tolerance_deg=0.4, largest_roll_deg=5.0, keep=10)
CLOCK_SCALES, CLOCK_STRIDE = (3.0, 1.0, 0.5, 0.25), 4
"""Tolerances of the fine fit, and the step between the columns that it uses."""
LEAST_COLUMNS = 0.3
"""Smallest share of columns with evidence for which a photograph helps to find the clock."""
SHARED_DEG = (1 / 1500, 1e-4)
"""Places closer than this share a horizon, for the coarse and the fine fit: about 75 m and 11 m [degrees]."""
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
        self._views: list = []
        self._horizons: OrderedDict = OrderedDict()

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
            check_skyline(evidence)
        except (PhotoError, MissingMetadataError):
            return False
        informative = EvidenceStack.informative_columns(evidence.probability)
        if len(informative) < LEAST_COLUMNS * evidence.probability.shape[1]:
            return False
        problem = SkylineProblem(evidence, prior)
        camera = problem.prior.camera
        search = CLOCK_SEARCH.for_picture(camera.hfov_deg, skyline_relief_deg(problem.stack, camera))
        self._views.append((problem, search))
        return True

    def __call__(self, number, place, kind):
        """Log-likelihood of a photograph at a `Placed`; None outside the DEM.

        The coarse one is summed over the headings, for an eye above the DEM. The fine one is that of the best pose,
        averaged over the elevations of the eye: near terrain rises or sinks with the eye, so that one wrong elevation
        prefers places which are tens of metres off.

        Parameters
        ----------
        number : int
            Of the photograph, in the order in which `add` took them.
        place : Placed
        kind : int
            `COARSE` or `FINE`.
        """
        horizons = self._horizons_at(place, kind)
        if horizons is None:
            return None
        with one_blas_thread():
            value = self._coarse(number, horizons) if kind == COARSE else self._fine(number, horizons, place.error_m)
        return float(value.max() + np.log(np.mean(np.exp(value - value.max()))))

    def _coarse(self, number, horizons):
        """Log-likelihoods of the headings."""
        problem, search = self._views[number]
        found = coarse_search(problem.stack, problem.prior.camera, [HorizonCurve(horizons[0])], search)[0]
        return table()["temperature"] * found.score

    def _fine(self, number, horizons, error_m):
        """Log-likelihoods of the elevations of the eye, each with its best pose."""
        problem, search = self._views[number]
        curves = [HorizonCurve(each) for each in horizons]
        found = coarse_search(problem.stack, problem.prior.camera, curves, search)
        starts = np.concatenate([each.candidates for each in found])
        starts = np.column_stack([starts, np.zeros((len(starts), 2))])
        owner = np.concatenate([np.full(len(each.candidates), eye) for eye, each in enumerate(found)])
        before, finer = curves_of([horizons[eye] for eye in owner]), (CLOCK_SCALES, CLOCK_STRIDE)
        _, score = best_over_scales(problem, before, starts, error_m, finer)
        best = np.full(len(horizons), -np.inf)
        np.maximum.at(best, owner, score)
        return table()["temperature"] * best

    def _horizons_at(self, place, kind):
        """The horizon of the assumed eye, for the fine fit also those of its other elevations; None outside the DEM."""
        key = kind, round(place.longitude_deg / SHARED_DEG[kind]), round(place.latitude_deg / SHARED_DEG[kind])
        if key not in self._horizons:
            try:
                self._horizons[key] = self._computed(place, kind)
            except ObserverError:
                self._horizons[key] = None
            while len(self._horizons) > KEPT_HORIZONS:
                self._horizons.popitem(last=False)
        return self._horizons[key]

    def _computed(self, place, kind):
        observer = Observer(place.longitude_deg, place.latitude_deg, self.eye_height_m)
        around = Surroundings(self.dem, place.longitude_deg, place.latitude_deg, CLOCK_HORIZON)
        assumed = horizon_from(around, eye_elevation_m(self.dem, around.frame, observer))
        if kind == COARSE:
            return (assumed,)
        eye_m = assumed.eye_elevation_m
        recorded = None if place.elevation_m is None else place.elevation_m - eye_m
        offsets = eye_offsets_m(assumed.cell_m, recorded)
        return (assumed, *(horizon_from(around, eye_m + up) for up, _ in offsets))


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
    # Only as many photographs are read as the search takes, spread over the walk; where one shows no skyline, its
    # neighbour within a minute may.
    order = spread_over_walk(times_s, options)
    order += sorted(set(range(len(times_s))) - set(order))
    for count, index in enumerate(order):
        if len(times) == options.photos:
            break
        checkpoint(progress, 0.2 * count / len(order))
        apart = all(abs(times_s[index] - other) >= options.apart_s for other in times)
        if apart and fit.add(paths[index]):
            times.append(float(times_s[index]))
    checkpoint(progress, 0.2)
    return solve_clock(times, track, fit, options, track_options, subtask(progress, 0.2, 1.0))
