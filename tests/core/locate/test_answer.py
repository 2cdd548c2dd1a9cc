import numpy as np
from skyline_viewshed.core.base.angles import difference


def test_two_unlike_peaks_are_found_in_place(unlike_search):
    best = unlike_search.found.places[0]
    assert unlike_search.found.status == "accepted"
    assert unlike_search.away_m(best) < 150
    assert abs(difference(best.oriented.heading_deg, 0.0)) < 1.0
    assert unlike_search.found.p_correct > 0.85


def test_a_cone_is_ambiguous_by_its_symmetry(cone_search):
    found = cone_search.found
    assert found.status != "accepted"
    col, row = cone_search.terrain.pixel_of(
        np.array([place.longitude_deg for place in found.places]),
        np.array([place.latitude_deg for place in found.places]),
    )
    ring_m = np.hypot(col - 80, row - 80) * 100.0
    true_m = 65 * 100.0
    good = np.array([place.score for place in found.places]) > found.places[0].score - 0.1
    assert good.sum() >= 2
    # All equally good places lie at the true distance from the cone, in any direction.
    assert np.abs(ring_m[good] - true_m).max() < 450


def test_the_region_of_the_cone_is_a_ring_and_that_of_the_peaks_a_spot(cone_search, unlike_search):
    assert len(unlike_search.found.region) < 0.2 * len(cone_search.found.region)
    index = cone_search.index
    col, row = cone_search.terrain.pixel_of(index.longitude_deg, index.latitude_deg)
    bearing = np.degrees(np.arctan2(col - 80, 80 - row))[cone_search.found.region] % 360
    assert len(np.unique(bearing // 45)) == 8


def test_the_oriented_photo_holds_what_the_report_draws(unlike_search):
    seen = unlike_search.found.places[0].oriented
    assert seen.evidence is not None and seen.horizon is not None and seen.preview is not None
    assert seen.eye_elevation_m == np.float64(seen.horizon.eye_elevation_m)
    assert seen.p_correct == unlike_search.found.places[0].probability
