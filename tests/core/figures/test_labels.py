from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.figures.labels import LabelOptions, lay_out_labels

OPTIONS = LabelOptions()


def boxes(labels):
    return np.array([[p.left_px, p.top_px, p.left_px + p.width_px, p.top_px + p.height_px] for p in labels])


def overlap(a, b):
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def test_a_lone_label_hangs_centred_above_its_point():
    (label,) = lay_out_labels([200.0], [150.0], [80.0], (400, 300))
    assert label.left_px == 160 and label.top_px + label.height_px == 150 - OPTIONS.lead_px
    assert label.leader == (200.0, 150 - OPTIONS.lead_px, 150.0)


@settings(max_examples=60, deadline=None)
@given(st.lists(st.tuples(st.floats(0, 800), st.floats(0, 500), st.floats(10, 200)), min_size=1, max_size=40))
def test_nothing_overlaps_and_nothing_leaves_the_canvas(points):
    x, y, width = (np.array(column) for column in zip(*points))
    labels = lay_out_labels(x, y, width, (800, 500))
    box = boxes(labels)
    if len(labels):
        assert box[:, 0].min() >= 0 and box[:, 2].max() <= 800 and box[:, 1].min() >= 0 and box[:, 3].max() <= 500
    for i in range(len(labels)):
        for j in range(i):
            assert not overlap(box[i], box[j])
            for one, other in ((i, j), (j, i)):
                leader = labels[one].leader
                line = (leader[0], min(leader[1:]), leader[0], max(leader[1:]))
                assert not overlap((line[0] - 0.1, line[1], line[2] + 0.1, line[3]), box[other])
    for label in labels:
        assert label.left_px <= label.point_x_px <= label.left_px + label.width_px
        assert abs(label.leader[1] - label.leader[2]) <= OPTIONS.longest_lead_px + OPTIONS.line_px


def test_neighbours_slide_aside_for_one_another():
    labels = lay_out_labels([200.0, 210.0], [150.0, 150.0], [80.0, 80.0], (400, 300))
    assert [label.index for label in labels] == [0, 1]
    assert all(label.leader[1] == 150 - OPTIONS.lead_px for label in labels)


def test_the_more_important_label_gets_the_shorter_leader():
    labels = lay_out_labels([200.0, 212.0, 206.0], np.full(3, 150.0), np.full(3, 80.0), (400, 300))
    leads = [abs(label.leader[1] - label.leader[2]) for label in labels]
    assert len(labels) == 3 and leads[0] == min(leads) == OPTIONS.lead_px


def test_a_point_at_the_upper_edge_is_labelled_below():
    (label,) = lay_out_labels([200.0], [5.0], [80.0], (400, 300))
    assert label.top_px == pytest.approx(5 + OPTIONS.lead_px)
    assert label.leader == (200.0, label.top_px, 5.0)


def test_what_has_no_room_is_left_out():
    labels = lay_out_labels(np.full(60, 50.0), np.full(60, 40.0), np.full(60, 90.0), (100, 80))
    assert 1 <= len(labels) < 6
    assert lay_out_labels([50.0], [40.0], [200.0], (100, 80)) == ()
    assert lay_out_labels([], [], [], (100, 80)) == ()
