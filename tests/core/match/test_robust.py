from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.base.camera import project
from skyline_viewshed.core.base.model import SkylineEvidence
from skyline_viewshed.core.horizon.inner import InnerTerrain
from skyline_viewshed.core.match import fitting, robust
from skyline_viewshed.core.match.landmarks import Landmark
from skyline_viewshed.core.match.notes import edge_notes
from skyline_viewshed.core.match.prior import HeadingPrior
from skyline_viewshed.core.match.robust import RobustOptions, find_answers, match_robust, mirror_fits_better

FLAT = np.full((192, 256), 1 / 192, np.float32)


def solve(scene, **facts):
    return match_robust(scene.inputs(**facts))


def miss(found, heading_deg):
    return abs((found.best.pose.heading_deg - heading_deg + 180) % 360 - 180)


def width_of(found):
    return (found.heading_hi_deg - found.heading_lo_deg) % 360


def twins(match_scenes):
    """A scene, and the same with its mountains once more half a circle on."""
    scene = match_scenes.scene(8, 100.0)
    elevation = scene.horizon.elevation_deg.copy()
    elevation[1800:] = elevation[:1800]
    horizon = replace(scene.horizon, elevation_deg=elevation)
    rows = match_scenes.seen_rows(horizon, scene.small_camera, scene.pose)
    evidence = match_scenes.evidence_of_rows(rows, 256, 192, (1024, 768))
    return scene, replace(scene, horizon=horizon, evidence=evidence)


def blind(scene):
    """The scene with evidence that says nothing about the skyline."""
    return replace(scene, evidence=SkylineEvidence(FLAT, scene.evidence.best, 1024, 768))


def noisy(scene, seed):
    """The scene with rows picked at random for its skyline."""
    probability = np.random.default_rng(seed).dirichlet(np.full(192, 0.05), size=256).T.astype(np.float32)
    return replace(scene, evidence=replace(scene.evidence, probability=probability))


def marks_at(scene, *directions):
    """Landmarks where the scene's camera sees directions (azimuth, elevation)."""
    pixels = (project(scene.camera, scene.pose, *direction) for direction in directions)
    return [Landmark(float(x), float(y), *direction) for (x, y), direction in zip(pixels, directions)]


@pytest.mark.parametrize("seed", range(6))
def test_a_perfect_skyline_gives_the_pose(match_scenes, seed):
    rng = np.random.default_rng(seed)
    heading, pitch, roll = rng.uniform(0, 360), rng.uniform(-3, 8), rng.uniform(-6, 6)
    scene = match_scenes.scene(seed, heading, pitch, roll, rng.uniform(35, 65), focal_scale=rng.uniform(0.98, 1.02))
    found = solve(scene)
    assert miss(found, heading) < 0.2
    assert abs(found.best.pose.pitch_deg - pitch) < 0.2
    assert abs(found.best.pose.roll_deg - roll) < 0.5


def test_an_answer_in_its_place_is_not_lost_to_a_wide_tolerance_that_pulls_it_away(match_scenes, monkeypatch):
    """Near ground that the DEM draws wrong pulls wide fits aside, out of reach of the fine ones that come after."""
    fit = fitting.refine

    def pulled_aside(objective, trials, scale, stride=1, **rest):
        trials, score = fit(objective, trials, scale, stride, **rest)
        if stride == 1 and scale > 1:
            trials, score = trials + np.array([1.0, 20.0, 4.0, 0.0, 0.0]), score - 1
        return trials, score

    scene = match_scenes.scene(3, 211.0)
    monkeypatch.setattr(fitting, "refine", pulled_aside)
    assert miss(solve(scene), 211.0) < 0.2


@pytest.mark.parametrize("roll_deg", [-13.0, 10.0])
def test_a_rolled_picture_gives_the_pose(match_scenes, roll_deg):
    found = match_robust(match_scenes.scene(3, 250.0, 4.0, roll_deg).inputs())
    assert found.status == "accepted"
    assert abs(found.best.pose.heading_deg - 250.0) < 0.2
    assert abs(found.best.pose.roll_deg - roll_deg) < 0.5


def test_the_interval_holds_the_truth_and_runs_clockwise(match_scenes):
    found = solve(match_scenes.scene(3, 0.05))
    assert (0.05 - found.heading_lo_deg) % 360 <= width_of(found)
    assert width_of(found) < 10


def test_an_uncertain_position_widens_the_interval(match_scenes):
    scene = match_scenes.scene(3)
    near, far = solve(scene, position_error_m=5.0), solve(scene, position_error_m=400.0)
    assert width_of(far) > 1.5 * width_of(near)


def test_noise_without_a_skyline_is_not_accepted(match_scenes):
    found = solve(noisy(match_scenes.scene(5), 0))
    assert found.status in ("ambiguous", "rejected")
    assert found.p_correct < 0.7


def test_a_picture_without_any_evidence_is_rejected_with_advice(match_scenes):
    found = solve(blind(match_scenes.scene(5)))
    assert found.status == "rejected"
    assert found.best is None
    assert "sky mask" in found.message


def test_terrain_that_repeats_itself_is_ambiguous_and_both_answers_are_given(match_scenes):
    _, twin = twins(match_scenes)
    found = solve(twin)
    headings = [candidate.pose.heading_deg for candidate in found.candidates[:2]]
    assert found.status == "ambiguous"
    assert sorted(round(h) for h in headings) == [100, 280]


def test_a_prior_decides_between_twins_and_may_be_far_off_elsewhere(match_scenes):
    scene, twin = twins(match_scenes)
    assert miss(solve(twin, heading_prior=HeadingPrior(110.0, 10.0)), 100.0) < 1
    assert miss(solve(twin, heading_prior=HeadingPrior(290.0, 10.0)), 280.0) < 1
    # A clear skyline overrules a compass that points elsewhere.
    assert miss(solve(scene, heading_prior=HeadingPrior(250.0, 10.0)), 100.0) < 1


def test_a_compass_that_takes_no_part_is_offered_where_the_picture_leaves_the_heading_open(match_scenes):
    scene, twin = twins(match_scenes)
    assert any("110 degrees" in note for note in solve(twin, recorded_heading_deg=110.0).notes)
    clear = solve(scene, recorded_heading_deg=110.0)
    assert clear.status == "accepted" and not clear.notes


def test_an_answer_across_a_skyline_that_says_otherwise_is_not_accepted(match_scenes):
    """The same probabilities, but the line drawn through them runs against the horizon."""
    scene = match_scenes.scene(5)
    upside_down = replace(scene.evidence.best, row_px=scene.evidence.best.row_px.max() - scene.evidence.best.row_px)
    found = solve(replace(scene, evidence=replace(scene.evidence, best=upside_down)))
    assert solve(scene).status == "accepted"
    assert found.status == "ambiguous" and "does not follow the skyline" in found.message
    assert found.p_correct <= 0.5
    assert found.best == solve(scene).best


def test_a_flipped_picture_is_recognised_by_its_mirror_image(match_scenes):
    """Seven of 61 flipped photographs of known heading were accepted without this control, and none with it."""
    scene = match_scenes.scene(5)
    inputs = scene.inputs()
    eye = inputs.eyes[0]
    assert not mirror_fits_better(inputs, find_answers(inputs), RobustOptions())
    flipped = inputs.mirrored(eye)
    assert mirror_fits_better(flipped, find_answers(flipped), RobustOptions())
    again = flipped.mirrored(eye).evidence
    assert np.array_equal(again.probability, scene.evidence.probability)
    assert np.array_equal(again.best.row_px, scene.evidence.best.row_px)


def test_an_acceptance_is_taken_back_if_the_mirror_image_fits_better(match_scenes, monkeypatch):
    scene = match_scenes.scene(5)
    monkeypatch.setattr(robust, "mirror_fits_better", lambda *given: True)
    found = solve(scene)
    assert found.status == "ambiguous" and "mirror image" in found.message and found.p_correct <= 0.5
    marks = marks_at(scene, (115.0, 5.0), (131.0, 6.0))
    assert solve(scene, landmarks=tuple(marks)).status == "accepted"


def test_two_landmarks_solve_a_picture_without_a_skyline(match_scenes):
    scene = match_scenes.scene(9, 222.0, 4.0, 2.0)
    found = solve(noisy(scene, 1), landmarks=marks_at(scene, (210.0, 5.0), (236.0, 8.0)))
    assert miss(found, 222.0) < 0.7
    assert abs(found.best.pose.pitch_deg - 4.0) < 0.7
    assert any("Landmark 1 lies" in note for note in found.notes)


def test_landmarks_alone_are_enough_where_nothing_else_can_be_seen(match_scenes):
    scene = match_scenes.scene(9, 222.0, 4.0, 2.0)
    found = solve(blind(scene), landmarks=marks_at(scene, (205.0, 1.0), (236.0, 8.0), (222.0, 12.0)))
    assert found.status == "accepted"
    assert miss(found, 222.0) < 0.5


def cut_off(scene, lowered=False):
    """The scene with a DEM that ends early all around; if lowered, the range is missing near its right edge."""
    elevation = scene.horizon.elevation_deg.copy()
    if lowered:
        missing = (np.arange(3600) / 10 - scene.pose.heading_deg - 12) % 360 < 60
        elevation[missing] -= 4.0
    return replace(scene, horizon=replace(scene.horizon, elevation_deg=elevation, clipped=np.ones(3600, bool)))


def edge_share(notes):
    """Per cent of the frame in which the note leaves open where the horizon is; None without the note."""
    shares = [note.facts["share"] for note in notes if "a larger DEM" in note]
    return float(shares[0]) if shares else None


def test_a_horizon_cut_off_by_the_dem_is_remarked_on_while_the_heading_is_open(match_scenes):
    found = solve(cut_off(twins(match_scenes)[1]))
    assert found.status == "ambiguous" and edge_share(found.notes) == 100


def test_it_is_not_where_an_accepted_picture_shows_that_nothing_higher_follows(match_scenes):
    found = solve(cut_off(match_scenes.scene(3)))
    assert found.status == "accepted" and edge_share(found.notes) is None


def test_it_is_where_the_picture_rises_above_what_the_dem_has(match_scenes):
    scene = match_scenes.scene(3)
    right, lowered = (find_answers(cut_off(scene, missing).inputs()) for missing in (False, True))
    answers = replace(right, objectives=lowered.objectives)
    assert 20 < edge_share(edge_notes(answers, "accepted")) < 60 < edge_share(edge_notes(answers, "ambiguous"))


def test_residuals_speak_of_the_full_picture_s_pixels(match_scenes):
    scene = match_scenes.scene(2)
    shifted = replace(scene.evidence.best, row_px=scene.evidence.best.row_px + 2.0)
    found = solve(replace(scene, evidence=replace(scene.evidence, best=shifted)))
    assert np.nanmedian(found.residual_px) == pytest.approx(8.0, abs=1.0)


def test_the_curve_covers_the_circle_and_peaks_at_the_answer(match_scenes):
    found = solve(match_scenes.scene(4, 77.0))
    assert len(found.curve_heading_deg) == len(found.curve_score) == 900
    assert abs(found.curve_heading_deg[found.curve_score.argmax()] - 77.0) < 1.0


def test_the_same_input_gives_the_same_answer(match_scenes):
    scene = match_scenes.scene(6)
    assert solve(scene).candidates == solve(scene).candidates


def look(plain, crests, **changes):
    """Solve the plain before a range with the crests that the DEM shows; None: no inner terrain at all."""
    scene = replace(plain.scene, evidence=replace(plain.evidence, **changes))
    return solve(scene, inner=crests and InnerTerrain(crests, None))


def test_the_range_behind_is_matched_where_the_dem_has_a_crest_on_the_striking_line(plain_before_range):
    found = look(plain_before_range, plain_before_range.crests())
    assert found.behind and found.status == "accepted"
    assert miss(found, 200.0) < 0.2
    assert np.nanmedian(np.abs(found.residual_px)) < 4, "the residuals are those to the line that was matched"
    assert any("nearby crest" in note for note in found.notes)


@pytest.mark.parametrize("elsewhere_deg", [-6.0, 1.9])
def test_it_is_not_where_the_dem_knows_no_such_crest(plain_before_range, elsewhere_deg):
    found = look(plain_before_range, plain_before_range.crests(elsewhere_deg))
    assert not found.behind and found.status != "accepted"


def test_without_a_rival_or_terrain_there_is_one_look(plain_before_range):
    no_rival = look(plain_before_range, plain_before_range.crests(), rival=None)
    no_terrain = look(plain_before_range, None)
    for found in (no_rival, no_terrain):
        assert not found.behind and found.status != "accepted"


def test_an_accepted_answer_is_not_looked_behind(plain_before_range, monkeypatch):
    looks, judged = [], robust._judged
    monkeypatch.setattr(robust, "_judged", lambda *given: looks.append(given[0]) or judged(*given))
    striking = replace(plain_before_range.evidence, rival=None)
    scene = replace(plain_before_range.scene, evidence=replace(plain_before_range.scene.evidence, rival=striking))
    found = solve(scene, inner=InnerTerrain(plain_before_range.crests(), None))
    assert found.status == "accepted" and not found.behind and len(looks) == 1
