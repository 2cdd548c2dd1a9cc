"""One photograph's card, part by part."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.base.model import Orientation, OrientedPhoto
from skyline_viewshed.core.report.card import photo_card

pytest.importorskip("PIL")


def without_pictures(card):
    return re.sub(r"data:image/\w+;base64,[^\"]*", "", card)


def test_a_card_without_pictures_has_all_its_numbers(painted):
    card = photo_card(painted(), 7, picture_px=0)
    assert 'id="photo-7"' in card and "123.4°" in card and "All numbers" in card
    assert card.count("<svg") == 1, "the rose alone"
    assert "data:image" not in card and "<img" not in card


def test_the_picture_is_there_once_and_is_seen_twice(painted):
    card = photo_card(painted(), 3)
    assert card.count("data:image/jpeg") == 1 and card.count("data:image/png") == 1
    assert card.count('xlink:href="#p3-picture"') == card.count('xlink:href="#p3-lines"') == 2


@pytest.mark.parametrize(
    ("status", "words"), [("accepted", None), ("ambiguous", "most likely of several"), ("rejected", "best guess")]
)
def test_a_heading_that_is_not_certain_says_so_beside_it(painted, status, words):
    card = photo_card(painted(status), 1, picture_px=0)
    assert re.findall(r'<span class="remark">([^<]*)', card) == ([words] if words else [])
    assert f'class="card item is-{status}"' in card


def test_two_alternatives_are_named_and_no_more(painted):
    photo = painted()
    many = replace(photo.orientation, candidates=photo.orientation.candidates * 2)
    (others,) = re.findall(r'<p class="others">(.*?)</p>', photo_card(replace(photo, orientation=many), 1))
    assert others.count("°") == 2 and "2: 240.4° (2.0 %)" in others and "3: 323.4° (1.0 %)" in others
    alone = replace(photo.orientation, candidates=photo.orientation.candidates[:1])
    assert 'class="others"' not in photo_card(replace(photo, orientation=alone), 1)


def test_what_is_unknown_has_no_place_of_its_own(painted):
    photo = painted(metadata=None)
    bare = replace(photo.orientation, p_correct=None, heading_lo_deg=None, ncc=None, notes=())
    card = photo_card(replace(photo, orientation=bare), 1, picture_px=0)
    for part in ("interval-line", 'class="chance"', 'class="notes"', "<dt>NCC</dt>", '<span class="quiet">'):
        assert part not in card, part


def test_the_figure_of_the_ground_is_reduced_and_keeps_its_stated_size(painted):
    panels = np.random.default_rng(0).integers(0, 255, (300, 1500, 3)).astype(np.uint8)
    large, small = (photo_card(painted(), 1, picture_px=width, panels=panels) for width in (1500, 200))
    assert 'width="1500" height="300"' in large and 'width="1500" height="300"' in small
    assert len(small) < 0.5 * len(large)
    assert without_pictures(large) == without_pictures(small)


def test_a_photo_that_failed_shows_its_picture_where_there_is_one_and_its_reason():
    failed = Orientation("failed", "No <horizon>.", notes=("A note.",))
    bare = photo_card(OrientedPhoto("/x/a.jpg", failed), 1)
    seen = photo_card(OrientedPhoto("/x/a.jpg", failed, preview=np.zeros((30, 40, 3), np.uint8)), 1)
    for card in (bare, seen):
        assert "No &lt;horizon&gt;." in card and "A note." in card and "<bdi>a.jpg</bdi>" in card
    assert "failed-body" in bare and "data:image/jpeg" in seen and "failed-body" not in seen


def test_extras_come_first_among_the_numbers(painted):
    numbers = photo_card(painted(), 1, {"Feature id": 7}, 0).split('<div class="numbers">')[1]
    assert numbers.index("Feature id") < numbers.index("Pose")
