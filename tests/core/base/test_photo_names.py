"""Which photograph a name in a table or file means."""

from __future__ import annotations

import pytest
from skyline_viewshed.core.base.photo_names import owners

DAY1, DAY2 = "/data/day1/IMG_0001.jpg", "/data/day2/IMG_0001.jpg"


@pytest.mark.parametrize("name", ["IMG_1.jpg", "/a/b/IMG_1.JPG", "C:\\photos\\IMG_1.png", "img_1", "b/Img_1.Heic"])
def test_one_photo_of_a_name_is_found_from_any_computer(name):
    assert owners([name, "IMG_10.jpg", "1.jpg"], ["/photos/IMG_1.jpg"]) == {name: "/photos/IMG_1.jpg"}


@pytest.mark.parametrize(
    "name", ["day1/IMG_0001.jpg", "day1\\img_0001.png", "/data/day1/IMG_0001.jpg", "./DAY1/IMG_0001"]
)
def test_folders_decide_between_photos_of_one_name(name):
    assert owners([name], [DAY1, DAY2]) == {name: DAY1}


def test_a_name_that_fits_several_photos_is_not_given_to_any():
    assert owners(["IMG_0001.jpg", "labels/IMG_0001.jpg"], [DAY1, DAY2]) == {
        "IMG_0001.jpg": None,
        "labels/IMG_0001.jpg": None,
    }


def test_the_same_extension_decides_between_a_picture_and_its_copy():
    assert owners(["IMG_1.jpg", "IMG_1.HEIC"], ["a/IMG_1.heic", "a/IMG_1.jpg"]) == {
        "IMG_1.jpg": "a/IMG_1.jpg",
        "IMG_1.HEIC": "a/IMG_1.heic",
    }


def test_the_label_of_a_photo_that_was_not_chosen_does_not_go_to_its_namesake():
    assert owners(["day1/IMG_0001.jpg", "day2/IMG_0001.jpg"], [DAY2]) == {"day2/IMG_0001.jpg": DAY2}
    assert owners(["a/IMG_0001.jpg", "b/IMG_0001.jpg"], [DAY2]) == {"a/IMG_0001.jpg": None, "b/IMG_0001.jpg": None}
    assert owners(["a/IMG_0001.jpg", "IMG_0001.jpg"], [DAY2]) == {"IMG_0001.jpg": DAY2}


def test_two_points_of_one_photo_are_one_photo():
    assert owners(["IMG_0001.jpg"], [DAY1, DAY1]) == {"IMG_0001.jpg": DAY1}
