from dataclasses import replace

import numpy as np
import pytest
from scenes import mountain_scene
from skyline_viewshed.core.paper.horizon import PaperHorizonOptions, paper_horizon
from skyline_viewshed.core.paper.match import match_paper
from skyline_viewshed.core.paper.method import PaperOptions, orient_by_paper, paper_fov_deg
from skyline_viewshed.core.paper.skyline import PaperSkylineOptions, extract_skyline_paper


@pytest.mark.parametrize("size, expected", [((4032, 3024), (73.74, 53.13)), ((3024, 4032), (53.13, 73.74))])
def test_the_rule_gives_the_published_74_and_53_degrees_at_24_mm(size, expected):
    assert paper_fov_deg(*size, 24) == pytest.approx(expected, abs=0.01)


@pytest.fixture(scope="module")
def seen():
    """A simulated photograph and the paper's horizon at its place."""
    scene = mountain_scene(3)
    return scene, paper_horizon(scene.terrain, scene.observer, PaperHorizonOptions(azimuth_step_deg=0.5))


def test_the_stages_follow_one_another_with_the_paper_s_field_of_view(seen):
    scene, horizon = seen
    found, skyline = orient_by_paper(scene.photo, scene.camera, horizon)
    expected = match_paper(extract_skyline_paper(scene.photo.pixels), *paper_fov_deg(640, 480, 35.0), horizon)
    assert found.status == "ambiguous"
    assert found.candidates == expected.candidates
    assert (skyline.width_px, skyline.height_px) == (640, 480)


def test_without_a_35_mm_equivalent_the_camera_gives_the_field_of_view(seen):
    scene, horizon = seen
    silent = replace(scene.photo, metadata=replace(scene.photo.metadata, focal_length_35mm=None))
    found, _ = orient_by_paper(silent, scene.camera, horizon)
    assert found.best.camera.hfov_deg == pytest.approx(scene.camera.hfov_deg)
    assert found.best.camera.hfov_deg != pytest.approx(paper_fov_deg(640, 480, 35.0)[0], abs=0.5)


def test_the_options_reach_the_stages(seen):
    scene, horizon = seen
    _, plain = orient_by_paper(scene.photo, scene.camera, horizon)
    _, raw = orient_by_paper(scene.photo, scene.camera, horizon, PaperOptions(PaperSkylineOptions(passes=0)))
    assert np.abs(np.diff(raw.row_px)).max() > np.abs(np.diff(plain.row_px)).max()
