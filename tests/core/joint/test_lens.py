"""The focal length that photographs of one lens share."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from joint_walks import photo
from skyline_viewshed.core.base.camera import Camera, focal_from_35mm_px
from skyline_viewshed.core.base.uncertainty import PoseUncertainty
from skyline_viewshed.core.joint.alone import alone_of
from skyline_viewshed.core.joint.lens import MOST, lens_ratios

RECORDED = focal_from_35mm_px(800, 600, 26.0)


def taken(scale, status="accepted", **facts):
    camera = Camera(800, 600, RECORDED * scale)
    found = photo(f"{scale}.jpg", status, [(10.0, 0.6)], camera=camera, **{"focal_length_35mm": 26.0, **facts})
    return replace(found, orientation=replace(found.orientation, uncertainty=PoseUncertainty(focal_relative=0.005)))


def ratios(photos):
    return [float(ratio[0]) for ratio in lens_ratios(photos, [alone_of(photo) for photo in photos])]


def test_candidates_with_the_focal_length_of_the_others_are_favoured_within_bounds():
    others = [taken(1.02), taken(1.021), taken(1.019)]
    same, different = ratios([*others, taken(1.02, "ambiguous")])[3], ratios([*others, taken(0.96, "ambiguous")])[3]
    assert 1.5 < same <= MOST * (1 + 1e-9) and different == pytest.approx(1 / MOST)


@pytest.mark.parametrize(
    "photos",
    [
        [taken(1.02), taken(1.02, "ambiguous")],
        [taken(1.02, "ambiguous"), taken(1.02, "ambiguous"), taken(1.02, "ambiguous")],
        [taken(1.02, device="Other phone"), taken(1.02, device="Other phone"), taken(1.02)],
        [taken(1.02, focal_length_35mm=None) for _ in range(4)],
    ],
    ids=["one other", "none accepted", "another phone", "none recorded"],
)
def test_without_two_accepted_photographs_of_the_lens_it_says_nothing(photos):
    assert np.array(ratios(photos))[-1] == 1.0
