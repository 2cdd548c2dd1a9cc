"""Orientations kept as files: nothing is lost, nothing stale or damaged is taken, nothing in a file is executed."""

from __future__ import annotations

import json
import os
from dataclasses import fields, is_dataclass, replace
from datetime import datetime

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from skyline_viewshed.core.base.camera import Camera, Pose
from skyline_viewshed.core.base.errors import SkylineNotFoundError
from skyline_viewshed.core.base.landmark_hint import LandmarkHint
from skyline_viewshed.core.base.messages import Message
from skyline_viewshed.core.base.model import (
    Candidate,
    HorizonProfile,
    Orientation,
    OrientedPhoto,
    PhotoMetadata,
    Skyline,
    SkylineEvidence,
)
from skyline_viewshed.core.batch import PhotoRequest
from skyline_viewshed.core.io import orientation_file
from skyline_viewshed.core.io.file_state import dataset_state
from skyline_viewshed.core.io.orientation_file import orientation_mark, packed, unpacked
from skyline_viewshed.core.pipeline import OrientOptions

MARK = "0123456789abcdef"


def oriented_photo(path="/photos/Zoë 🏔.jpg", message="Sure.", p_correct=0.97):
    """An answer with something in every field."""
    random = np.random.default_rng(1)
    camera = Camera(4000, 3000, 2900.5, 3.0, -2.0, 0.01)
    candidates = (Candidate(Pose(359.9, -2.5, 0.3), camera, -12.0, 0.9), Candidate(Pose(12.0), camera, -14.0))
    curve = np.arange(0, 360, 0.4), random.normal(size=900)
    answer = Orientation("accepted", message, candidates, 359.0, 0.8, p_correct, *curve, 0.9, None, np.inf,
                         random.normal(size=512), ("A note.", "Another."))  # fmt: skip
    line = Skyline(random.uniform(0, 300, 512), np.float32(random.uniform(size=512)), 512, 384)
    evidence = SkylineEvidence(random.random((384, 512), np.float32), line, 4000, 3000, (1, 2, 3, 4),
                               leaves_frame=np.zeros(512, np.float32))  # fmt: skip
    flags = random.random(3600) < 0.1
    far = np.where(flags, np.nan, random.uniform(1e2, 1e5, 3600))
    horizon = HorizonProfile(np.arange(3600) / 10, far / 1e4, far, flags, ~flags, 1803.25, np.float64(30.0), far)
    metadata = PhotoMetadata(path, 4000, 3000, 46.5, 8.0, taken_at=datetime(2021, 7, 3, 9, 30, 1), notes=("One.",))
    preview = random.integers(0, 256, (768, 1024, 3), np.uint8)
    return OrientedPhoto(path, answer, metadata, preview, camera, line, evidence, horizon, 8.0, 46.5, 1803.25, None,
                         float("nan"), 12.5)  # fmt: skip


def assert_same(one, other, where="photo"):
    """Everything equal, NaN to NaN, arrays with their kind of number."""
    if is_dataclass(one):
        assert type(one) is type(other), where
        for field in fields(one):
            assert_same(getattr(one, field.name), getattr(other, field.name), f"{where}.{field.name}")
    elif isinstance(one, np.ndarray):
        assert one.dtype == other.dtype, where
        np.testing.assert_array_equal(one, other, where)
    elif isinstance(one, tuple):
        assert isinstance(other, tuple) and len(one) == len(other), where
        for index, pair in enumerate(zip(one, other)):
            assert_same(*pair, f"{where}[{index}]")
    else:
        assert one == other or (one != one and other != other), where


@pytest.fixture
def kept(tmp_path):
    path = tmp_path / "a.npz"
    path.write_bytes(packed(oriented_photo(), MARK))
    return path


def test_what_is_kept_comes_back_as_it_was(kept):
    assert_same(oriented_photo(), unpacked(kept, MARK))


def test_an_answer_of_which_next_to_nothing_is_known_comes_back_too(tmp_path):
    photo = OrientedPhoto("", Orientation("rejected", "No skyline."))
    (tmp_path / "a.npz").write_bytes(packed(photo, MARK))
    assert_same(photo, unpacked(tmp_path / "a.npz", MARK))


def test_messages_come_back_with_template_and_facts(tmp_path):
    reason = Message("The picture is only {width} x {height} pixels.", width=9, height=8)
    error = SkylineNotFoundError(reason)
    note = Message("The recorded coordinates lie outside the range of latitude and longitude and were ignored.")
    photo = OrientedPhoto("", Orientation("rejected", error.message, notes=(note,)))
    (tmp_path / "a.npz").write_bytes(packed(photo, MARK))
    answer = unpacked(tmp_path / "a.npz", MARK).orientation
    assert answer.message == str(error) and answer.message.template == error.message.template
    assert isinstance(answer.message.facts["reason"], Message) and answer.message.facts["reason"].facts == reason.facts
    assert answer.notes == (note,) and answer.notes[0].template == note


def test_pixel_scores_that_no_report_draws_are_left_out(tmp_path):
    photo = oriented_photo()
    scores = np.ones((384, 512), np.float32)
    (tmp_path / "a.npz").write_bytes(
        packed(replace(photo, evidence=replace(photo.evidence, sky_score=scores, ridge_score=scores)), MARK)
    )
    assert_same(photo, unpacked(tmp_path / "a.npz", MARK))


@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.too_slow])
@given(path=st.text(), message=st.text(), p_correct=st.floats())
def test_any_text_and_any_number_survive(tmp_path_factory, path, message, p_correct):
    photo = OrientedPhoto(path, Orientation("ambiguous", message, p_correct=p_correct))
    target = tmp_path_factory.getbasetemp() / "any.npz"
    target.write_bytes(packed(photo, MARK))
    assert_same(photo, unpacked(target, MARK))


def test_another_mark_is_another_photo(kept):
    assert unpacked(kept, MARK[::-1]) is None


@pytest.mark.parametrize("share", [0.0, 0.001, 0.3, 0.9, 0.999])
def test_half_a_file_is_none(kept, share):
    content = kept.read_bytes()
    kept.write_bytes(content[: int(share * len(content))])
    assert unpacked(kept, MARK) is None


def test_damaged_bytes_are_no_answer_or_the_same_one(kept):
    content, random = kept.read_bytes(), np.random.default_rng(2)
    for place in random.integers(0, len(content), 60):
        kept.write_bytes(content[:place] + bytes([content[place] ^ 0x55]) + content[place + 1 :])
        found = unpacked(kept, MARK)
        if found is not None:  # the archive has spare bytes, as times of change
            assert_same(oriented_photo(), found)


def test_a_missing_file_and_a_folder_are_none(tmp_path):
    assert unpacked(tmp_path / "gone.npz", MARK) is None
    assert unpacked(tmp_path, MARK) is None


class Bomb:
    """Touches a file when a pickle brings it back."""

    def __init__(self, path):
        self.path = path

    def __reduce__(self):
        return os.mkdir, (self.path,)


def test_nothing_in_a_file_is_executed(tmp_path):
    bomb = np.array([Bomb(str(tmp_path / "exploded"))], object)
    photo = {"kind": "OrientedPhoto", "path": {"array": "array_0"}, "orientation": None}
    tree = np.frombuffer(json.dumps({"mark": MARK, "photo": photo}).encode(), np.uint8)
    np.savez(tmp_path / "a.npz", tree=tree, array_0=np.zeros(1))
    assert unpacked(tmp_path / "a.npz", MARK) is not None, "without the pickle it is a file like any other"
    np.savez(tmp_path / "b.npz", tree=tree, array_0=bomb)
    np.savez(tmp_path / "c.npz", tree=bomb)
    (tmp_path / "d.npz").write_bytes(bomb.dumps())
    for name in "bcd":
        assert unpacked(tmp_path / f"{name}.npz", MARK) is None, name
    assert not (tmp_path / "exploded").exists()


class DemFile:
    """The part of a DEM on which the mark depends."""

    def __init__(self, path, band=1):
        self.path, self.band = path, band

    def GetFileList(self):  # noqa: N802 - GDAL's name
        return [self.path]

    @property
    def state(self):
        return dataset_state(self.path, self), self.band


@pytest.fixture
def inputs(tmp_path):
    """A request, a DEM and options whose files exist."""
    for name in ("photo.jpg", "mask.png", "dem.tif"):
        (tmp_path / name).write_bytes(b"content")
    request = PhotoRequest(str(tmp_path / "photo.jpg"), 8.0, 46.5, sky_mask_path=str(tmp_path / "mask.png"))
    return request, DemFile(str(tmp_path / "dem.tif")), OrientOptions()


def test_the_mark_stays_while_nothing_changes(inputs):
    assert orientation_mark(*inputs) == orientation_mark(*inputs)


@pytest.mark.parametrize("name", ["photo.jpg", "mask.png", "dem.tif"])
@pytest.mark.parametrize("change", ["content", "time", "gone"])
def test_a_changed_file_changes_the_mark(inputs, tmp_path, name, change):
    before, path = orientation_mark(*inputs), tmp_path / name
    if change == "content":
        path.write_bytes(b"more content")
    elif change == "time":
        os.utime(path, ns=(1, 1))
    else:
        path.unlink()
    assert orientation_mark(*inputs) != before


def test_any_other_request_option_or_band_changes_the_mark(inputs):
    request, dem, options = inputs
    requests = [
        replace(request, **change)
        for change in (
            {"longitude_deg": 8.0000001},
            {"eye_height_m": 2.0},
            {"hfov_deg": 60.0},
            {"heading_deg": 10.0},
            {"landmarks": (LandmarkHint(1.0, 2.0, 8.0, 46.0),)},
            {"drawn_skyline": tuple((float(x), 300.0) for x in range(5000))},
            {"drawn_skyline": tuple((float(x), 300.0 + (x == 2500)) for x in range(5000))},
        )
    ]
    others = [
        replace(options, compass="prior"),
        replace(options, horizon=replace(options.horizon, max_distance_m=5e4)),
        replace(options, robust=replace(options.robust, full_fits=3)),
    ]
    marks = {orientation_mark(request, dem, options), *(orientation_mark(r, dem, options) for r in requests)}
    marks |= {orientation_mark(request, dem, other) for other in others}
    marks.add(orientation_mark(request, DemFile(dem.path, band=2), options))
    assert len(marks) == 1 + len(requests) + len(others) + 1


def test_another_version_of_the_program_changes_the_mark(inputs, tmp_path, monkeypatch):
    marks = {orientation_mark(*inputs)}
    (tmp_path / "core").mkdir()
    monkeypatch.setattr(orientation_file, "CORE", tmp_path / "core")
    for name in ("module.py", "weights.json", "network.npz"):
        (tmp_path / "core" / name).write_text("1")
        orientation_file._program.cache_clear()
        marks.add(orientation_mark(*inputs))
    orientation_file._program.cache_clear()
    assert len(marks) == 4


def test_every_table_of_the_program_counts():
    kinds = {path.suffix for path in orientation_file.CORE.rglob("*") if path.is_file()}
    # What reports look like does not change an answer; Python writes .pyc itself.
    assert kinds - {".css", ".html", ".js", ".pyc"} == set(orientation_file.PROGRAM)
