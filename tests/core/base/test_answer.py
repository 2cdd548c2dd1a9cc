"""Short names and the short text of an oriented photograph."""

import pytest
from skyline_viewshed.core.base.model import Orientation, OrientedPhoto


def test_short_names_give_the_best_answer(painted):
    photo = painted(heading_deg=123.4)
    assert (photo.status, photo.message) == ("accepted", "The horizon fits along the whole skyline.")
    assert (photo.heading_deg, photo.pitch_deg, photo.roll_deg) == pytest.approx((123.4, 3.0, 1.5))
    assert photo.hfov_deg == pytest.approx(50.0) and photo.p_correct == 0.97
    assert photo.heading_interval_deg == pytest.approx((123.0, 123.8))
    assert (photo.observer.longitude_deg, photo.observer.latitude_deg) == (8.0, 46.5)
    assert photo.observer.eye_elevation_m == 2001.7


def test_headings_lie_in_the_circle(painted):
    photo = painted(heading_deg=-10.0)
    assert photo.heading_deg == photo.view.pose.heading_deg == 350.0


def test_the_view_keeps_lens_place_and_doubt(painted):
    photo = painted()
    view = photo.view
    assert view.camera is photo.orientation.best.camera
    assert view.observer == photo.observer and view.path == photo.path
    assert view.uncertainty.heading_deg == pytest.approx(0.4 / 1.645, rel=1e-3)


def test_without_an_answer_nothing_is_made_up():
    photo = OrientedPhoto("/a/b.jpg", Orientation("failed", "The file is empty."))
    names = (
        "heading_deg",
        "pitch_deg",
        "roll_deg",
        "hfov_deg",
        "heading_interval_deg",
        "p_correct",
        "observer",
        "view",
    )
    assert [getattr(photo, name) for name in names] == [None] * len(names)
    assert repr(photo) == "<OrientedPhoto b.jpg: failed. The file is empty.>"


def test_the_text_is_one_line(painted):
    text = repr(painted(path="C:\\photos\\IMG_1.jpg"))
    assert text.startswith("<OrientedPhoto IMG_1.jpg: accepted, heading 123.40°, 90 % interval 123.00° to 123.80°")
    assert "p_correct 0.970" in text and "\n" not in text and len(text) < 200
