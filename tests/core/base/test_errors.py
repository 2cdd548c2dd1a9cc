"""Every error that a user meets carries a message that can be translated, with the reason inside."""

from __future__ import annotations

import ast
import inspect
from pathlib import Path

import pytest
from skyline_viewshed.core.base import errors
from skyline_viewshed.core.base.messages import Message

CORE = Path(errors.__file__).resolve().parent.parent
FAMILY = {name: kind for name, kind in vars(errors).items() if inspect.isclass(kind) and name.endswith("Error")}
REASON = Message("it is damaged ({reason}).", reason="no end")


@pytest.mark.parametrize(
    "error, sentence, facts",
    [
        (errors.UnreadablePhotoError("a.jpg", REASON), "The photo a.jpg cannot be read: it is damaged (no end).",
         {"path": "a.jpg", "reason": REASON}),
        (errors.UnreadableFeaturesError("a.csv", REASON),
         "The image features a.csv cannot be read: it is damaged (no end).", {"path": "a.csv", "reason": REASON}),
        (errors.SkylineNotFoundError(Message("The picture has a single colour.")),
         "The picture has a single colour. Use a photo that shows a mountain skyline, or supply a sky mask or a drawn "
         "skyline.", {"reason": "The picture has a single colour."}),
        (errors.ObserverOutsideDemError(7.5, 46.25),
         "The position 46.25000, 7.50000 (latitude, longitude) lies outside the DEM. Use a DEM that covers it, or "
         "correct the photo's coordinates.", {"latitude": "46.25000", "longitude": "7.50000"}),
        (errors.NoElevationAtObserverError(-7.5, 46.25),
         "The DEM has no elevation (nodata) at 46.25000, -7.50000 (latitude, longitude). Fill the void, use another "
         "DEM, or give the eye's elevation in HEIGHT_FIELD.", {"latitude": "46.25000", "longitude": "-7.50000"}),
        (errors.OutputError.of_file(Path("a.tif"), "No space left on device"),
         "The file a.tif cannot be written: No space left on device. Choose another folder or free some space.",
         {"path": "a.tif", "reason": "No space left on device"}),
    ],
)  # fmt: skip
def test_it_says_its_sentence_and_keeps_the_facts(error, sentence, facts):
    assert str(error) == error.message == sentence
    assert isinstance(error.message, Message) and error.message.facts == facts


def test_what_is_raised_in_the_core_is_made_of_messages():
    """No error of the family takes an English string."""
    offenders, seen = [], 0
    for path in sorted(CORE.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.Call) or getattr(node.func, "id", "") not in FAMILY:
                continue
            seen += 1
            offenders += [f"{path.name}:{node.lineno}" for argument in node.args if is_text(argument)]
    assert seen > 50 and offenders == []


def is_text(node):
    if isinstance(node, ast.BinOp):
        return is_text(node.left) or is_text(node.right)
    return isinstance(node, ast.JoinedStr) or (isinstance(node, ast.Constant) and isinstance(node.value, str))


def test_every_error_is_one_that_a_user_can_act_on_and_a_cancel_is_none():
    assert [name for name, kind in FAMILY.items() if not issubclass(kind, errors.SkylineViewshedError)] == []
    with pytest.raises(errors.Cancelled):
        try:
            raise errors.Cancelled
        except Exception:
            pytest.fail("a handler of errors has swallowed the user's cancel")


def test_a_photo_s_own_faults_end_the_photo_and_the_dem_s_end_the_run():
    photo = {name for name, kind in FAMILY.items() if issubclass(kind, errors.PhotoError)}
    run = {name for name, kind in FAMILY.items() if issubclass(kind, errors.TerrainError)}
    assert {"UnreadablePhotoError", "SkylineNotFoundError", "ObserverOutsideDemError"} < photo
    assert {"NoElevationAtObserverError", "ObserverError"} < photo and "UnusableDemError" in run
    assert not photo & run
