"""Evidence that photographs have in common counts once."""

from __future__ import annotations

import pytest
from joint_walks import photo
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.joint.shares import COMMON, evidence_weights

TELE = Camera(800, 600, 2000.0)


def test_what_others_show_counts_less():
    photos = [photo("a.jpg", "accepted"), photo("b.jpg", "ambiguous"), photo("c.jpg", "ambiguous", camera=TELE)]
    poses = {0: Pose(100.0), 1: Pose(250.0), 2: Pose(105.0)}
    assert evidence_weights(photos, poses, [0, 1, 2]) == pytest.approx({0: 1.0, 1: 1.0, 2: 1 - COMMON})
    assert evidence_weights(photos, poses, [2, 1, 0])[0] == pytest.approx(1 - COMMON * 0.35, abs=0.03)
