import numpy as np
import pytest
from fitted_places import places
from skyline_viewshed.core.locate.fit import FitOptions, best_over_scales, curves_of, lift, move


class Bowl:
    """A problem whose score falls with the square of the distance from a place and a height, whatever the trial."""

    def climb(self, curves, trials, error_m, scale, stride):
        return trials, -np.asarray(curves.elevation_deg).reshape(len(trials), -1)[:, 0]


TRUE = (8.003, 46.002)


def horizons_of(longitude_deg, latitude_deg, height_m, _trial=None):
    """Horizons whose first angle is the squared distance from the truth [hm2]."""
    from types import SimpleNamespace

    profiles = []
    for x, y in zip(longitude_deg, latitude_deg):
        north = (y - TRUE[1]) * 1111.95
        east = (x - TRUE[0]) * 1111.95 * np.cos(np.radians(46.0))
        miss = north**2 + east**2 + (0.0 if not np.isfinite(height_m) else ((height_m - 30.0) / 10.0) ** 2 - 9.0)
        no = np.zeros(4, bool)
        profiles.append(
            SimpleNamespace(
                elevation_deg=np.full(4, miss), distance_m=np.full(4, 9e3), cell_m=90.0, clipped=no, void=no
            )
        )
    return profiles


def test_places_move_to_where_the_horizon_fits_best():
    found = move(Bowl(), horizons_of, places([8.0], [46.0], [-99.0]), 600.0, FitOptions())
    north, east = (found.latitude_deg[0] - TRUE[1]) * 111_195, (found.longitude_deg[0] - TRUE[0]) * 77_000
    assert np.hypot(north, east) < 60
    # The score is a bowl of one per square hectometre: its curvature is two.
    assert found.curvature[0] == pytest.approx(np.eye(2) * 2e-4, abs=1e-6)


def test_a_step_of_nothing_fits_the_place_itself():
    options = FitOptions(stages=((0.0, 2),))
    found = move(Bowl(), horizons_of, places([8.0, 8.01], [46.0, 46.0], [-99.0, -100.0]), 600.0, options)
    assert sorted(found.longitude_deg) == [8.0, 8.01] and (found.score > -99.0).any()
    assert np.isnan(found.curvature).all()


def test_a_higher_eye_counts_if_it_fits_clearly_better():
    start = move(Bowl(), horizons_of, places([8.0], [46.0], [-99.0]), 600.0, FitOptions())
    found = lift(Bowl(), horizons_of, start, (15.0, 30.0, 60.0))
    assert found.eye_height_m[0] == 30.0 and found.score[0] > start.score[0] + 8
    assert np.isnan(lift(Bowl(), horizons_of, start, (61.0,)).eye_height_m[0])


def test_a_place_without_a_horizon_stays():
    start = places([8.0], [46.0], [1.0])
    kept = move(Bowl(), lambda x, y, h, _: [None] * len(x), start, 600.0)
    assert kept.score[0] == 1.0 and kept.longitude_deg[0] == 8.0


def test_the_curves_of_profiles_know_where_the_dem_ends():
    curves = curves_of(horizons_of([8.0, 8.1], [46.0, 46.0], np.nan))
    assert len(curves.distance_m) == 8 and not curves.clipped.any()


def test_the_best_pose_of_all_tolerances_is_kept():
    class Worse:
        """Every fit moves the heading by a degree, and the second one scores best."""

        def __init__(self):
            self.scores = iter([1.0, 3.0, 2.0])

        def climb(self, curves, trials, error_m, scale, stride):
            return trials + [1.0, 0, 0, 0, 0], np.full(len(trials), next(self.scores))

    trial, score = best_over_scales(Worse(), None, np.zeros((2, 5)), 10.0, ((2.0, 1.0, 0.5), 3))
    assert trial[:, 0].tolist() == [2.0, 2.0] and score.tolist() == [3.0, 3.0]
