"""The values of a photograph's fields, and what stands for the unknown."""

from dataclasses import replace

import numpy as np
import pytest
from skyline_viewshed.core.base.attributes import (
    has_position,
    oriented_fields,
    oriented_values,
    photo_fields,
    photo_values,
)
from skyline_viewshed.core.base.model import Orientation, OrientedPhoto, PhotoMetadata
from skyline_viewshed.core.base.uncertainty import PoseUncertainty


@pytest.mark.parametrize("fields", [photo_fields, oriented_fields])
def test_names_fit_a_shapefile_and_are_unique(fields):
    names = [spec.name for spec in fields()]
    assert len(set(names)) == len(names) and max(map(len, names)) <= 10


def test_aliases_are_translated():
    assert {spec.alias for spec in oriented_fields(str.upper)} == {spec.alias.upper() for spec in oriented_fields()}


def test_every_field_has_a_value(painted):
    photo = painted()
    values = oriented_values(photo, 60_000.0)
    assert list(values) == [spec.name for spec in oriented_fields()]
    assert list(photo_values(photo.metadata)) == [spec.name for spec in photo_fields()]
    assert values["heading"] == pytest.approx(123.4) and values["radius"] == 60_000.0
    assert values["heading_2"] == pytest.approx(240.4) and values["heading_3"] == pytest.approx(323.4)
    assert values["compass_df"] == pytest.approx(-2.4)
    assert values["observ_hgt"] == pytest.approx(1.7)
    assert (values["azim_2"] - values["azim_1"]) % 360 == pytest.approx(50.0)
    assert values["message"].endswith("whole skyline. The eye lies 12 m above the DEM.")
    assert photo_values(photo.metadata)["longitude"] == "8.0"


def test_the_unknown_is_none_and_never_nan(painted):
    failed = oriented_values(OrientedPhoto("a.jpg", Orientation("failed", "It is empty.")), 60_000.0)
    assert {name for name, value in failed.items() if value is not None} == {"status", "message"}
    assert oriented_values(painted(eye_elevation_m=np.inf), 6e4)["eye_z"] is None


def test_null_island_is_no_position():
    assert has_position(PhotoMetadata("a.jpg", 8, 6, 46.5, 8.0))
    for place in ((None, 8.0), (46.5, None), (0.0, 0.0)):
        assert not has_position(PhotoMetadata("a.jpg", 8, 6, *place))


def test_intervals_of_pitch_roll_and_field_of_view_follow_from_the_uncertainty(painted):
    photo = painted()
    spread = PoseUncertainty(pitch_deg=0.2, roll_deg=0.4, focal_relative=0.02)
    values = oriented_values(replace(photo, orientation=replace(photo.orientation, uncertainty=spread)), 60_000.0)
    assert values["pitch_hi"] - values["pitch_lo"] == pytest.approx(2 * 1.645 * 0.2, rel=1e-3)
    assert values["roll_hi"] - values["roll_lo"] == pytest.approx(2 * 1.645 * 0.4, rel=1e-3)
    assert (values["pitch_lo"] + values["pitch_hi"]) / 2 == pytest.approx(values["pitch"])
    focal = [1 / np.tan(np.radians(values[name]) / 2) for name in ("hfov_lo", "hfov", "hfov_hi")]
    assert focal[0] / focal[1] == pytest.approx(focal[1] / focal[2]) == pytest.approx(np.exp(1.645 * 0.02), rel=1e-3)
    unknown = oriented_values(photo, 60_000.0)
    assert {unknown[f"{name}_{end}"] for name in ("pitch", "roll", "hfov") for end in ("lo", "hi")} == {None}
