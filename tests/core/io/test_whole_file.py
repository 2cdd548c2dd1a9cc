"""Files of other writers reach their names whole or not at all."""

from __future__ import annotations

import os

import pytest
from skyline_viewshed.core.base.errors import OutputError
from skyline_viewshed.core.io import whole_file
from skyline_viewshed.core.io.whole_file import staged, unused_name


def test_until_the_end_there_is_no_file_and_the_older_one_stays(tmp_path):
    path = tmp_path / "Höhen 🏔.gpkg"
    path.write_text("older")
    with staged(path) as stage:
        (stage / path.name).write_text("newer")
        assert path.read_text() == "older"
        assert stage.parent == tmp_path and stage.name.startswith(".")
    assert path.read_text() == "newer"
    assert os.listdir(tmp_path) == [path.name]


def test_a_suffix_that_the_writer_adds_is_kept(tmp_path):
    with staged(tmp_path / "photos") as stage:
        (stage / "photos.gpkg").write_text("content")
    assert os.listdir(tmp_path) == ["photos.gpkg"]


@pytest.mark.parametrize("fault", [ValueError, KeyboardInterrupt])
def test_a_writer_that_fails_leaves_nothing(tmp_path, fault):
    with pytest.raises(fault), staged(tmp_path / "photos.gpkg") as stage:
        (stage / "photos.gpkg").write_text("half")
        raise fault
    assert os.listdir(tmp_path) == []


def test_of_several_files_the_main_one_comes_last_and_is_never_beside_older_parts(tmp_path, monkeypatch):
    for end in ("shp", "dbf", "qix"):
        (tmp_path / f"x.{end}").write_text("older")
    (tmp_path / "x.qml").write_text("the user's style")
    moved, replace = [], os.replace

    def watched(source, target):
        present = {path.suffix: path.read_text() for path in tmp_path.iterdir() if path.is_file()}
        assert ".shp" not in present and "older" not in present.values()
        moved.append(target.name)
        replace(source, target)

    monkeypatch.setattr(whole_file.os, "replace", watched)
    with staged(tmp_path / "x.shp") as stage:
        for end in ("shp", "dbf", "shx"):
            (stage / f"x.{end}").write_text("newer")
    assert moved == ["x.dbf", "x.shx", "x.shp"]
    assert sorted(os.listdir(tmp_path)) == ["x.dbf", "x.qml", "x.shp", "x.shx"]


def test_the_journal_of_an_older_database_does_not_meet_the_new_one(tmp_path):
    path = tmp_path / "x.gpkg"
    for end in ("", "-wal", "-shm"):
        path.with_name(path.name + end).write_text("older")
    with staged(path) as stage:
        (stage / "x.gpkg").write_text("newer")
    assert os.listdir(tmp_path) == ["x.gpkg"] and path.read_text() == "newer"


def test_a_missing_folder_is_said_in_a_sentence(tmp_path):
    with pytest.raises(OutputError, match="missing does not exist"), staged(tmp_path / "missing" / "x.gpkg"):
        pytest.fail("there is nowhere to write")


def test_a_read_only_folder_is_said_in_a_sentence(tmp_path, monkeypatch):
    def refuse(self):
        raise PermissionError(13, "Permission denied", str(self))

    monkeypatch.setattr(whole_file.Path, "mkdir", refuse)  # root may write everywhere, so that no mode would do
    with pytest.raises(OutputError, match="x.gpkg cannot be written: Permission denied"), staged(tmp_path / "x.gpkg"):
        pytest.fail("there is nowhere to write")


def test_a_file_that_a_scanner_holds_for_a_moment_is_asked_for_again(tmp_path, monkeypatch):
    refusals, replace = [1, 2], os.replace

    def held(source, target):
        if refusals:
            refusals.pop()
            raise PermissionError(13, "Access is denied")
        replace(source, target)

    monkeypatch.setattr(whole_file.os, "replace", held)
    with staged(tmp_path / "x.gpkg") as stage:
        (stage / "x.gpkg").write_text("newer")
    assert os.listdir(tmp_path) == ["x.gpkg"]
    refusals[:] = [1] * 9
    with pytest.raises(OutputError, match="Access is denied"), staged(tmp_path / "y.gpkg") as stage:
        (stage / "y.gpkg").write_text("newer")
    assert os.listdir(tmp_path) == ["x.gpkg"]


def test_a_writer_that_writes_nothing_is_found_out(tmp_path):
    with pytest.raises(OutputError, match="No such file"), staged(tmp_path / "x.gpkg"):
        pass
    assert os.listdir(tmp_path) == []


def test_photos_of_one_name_keep_files_of_their_own():
    taken = set()
    assert [unused_name(stem, taken) for stem in ("a", "A", "a", "b")] == ["a", "A_2", "a_3", "b"]
