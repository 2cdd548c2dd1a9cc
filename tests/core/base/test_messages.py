"""A message reads as its English sentence and keeps template and facts wherever it goes."""

from __future__ import annotations

import copy
import json
import pickle
from pathlib import Path

import pytest
from skyline_viewshed.core.base.messages import Message

INNER = Message("its {width} x {height} pixels are too many.", width=9, height=8)
OUTER = Message("The photo {path} cannot be read: {reason}", path="/tmp/{a} b.jpg", reason=INNER)
SENTENCE = "The photo /tmp/{a} b.jpg cannot be read: its 9 x 8 pixels are too many."


def test_it_is_its_english_sentence():
    assert OUTER == SENTENCE and str(OUTER) == SENTENCE and f"{OUTER}" == SENTENCE
    assert ", ".join([OUTER, "x"]) == f"{SENTENCE}, x"
    assert json.loads(json.dumps([OUTER])) == [SENTENCE]


def test_it_keeps_template_and_facts():
    assert OUTER.template == "The photo {path} cannot be read: {reason}"
    assert OUTER.facts["path"] == "/tmp/{a} b.jpg"
    assert OUTER.facts["reason"].facts == {"width": 9, "height": 8}


def test_it_compares_and_hashes_as_the_sentence():
    other = Message("{all}", all=SENTENCE)
    assert other == OUTER and len({other, OUTER, SENTENCE}) == 1
    assert Message("a") != Message("b")


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_pickle_and_copy_keep_the_structure(protocol):
    for twin in (pickle.loads(pickle.dumps(OUTER, protocol)), copy.copy(OUTER), copy.deepcopy(OUTER)):
        assert twin == OUTER and isinstance(twin, Message)
        assert twin.template == OUTER.template and twin.facts["reason"].template == INNER.template


def test_it_is_restored_from_template_and_facts():
    twin = Message.restored(OUTER.template, dict(OUTER.facts))
    assert twin == OUTER and twin.facts == OUTER.facts


def test_it_cannot_be_changed():
    with pytest.raises(AttributeError):
        OUTER.template = "x"
    with pytest.raises(AttributeError):
        OUTER.other = "x"
    with pytest.raises(TypeError):
        OUTER.facts["path"] = "x"


def test_of_other_facts_the_text_is_taken():
    assert Message("{path}", path=Path("/a/b")).facts == {"path": str(Path("/a/b"))}


def test_a_missing_fact_is_a_fault_of_the_program():
    with pytest.raises(KeyError, match="path"):
        Message("The DEM {path} does not exist.")


def test_a_fact_may_have_any_name():
    assert Message("{template} {cls}", template="a", cls="b") == "a b"


def test_its_repr_shows_the_call():
    assert repr(INNER) == "Message('its {width} x {height} pixels are too many.', width=9, height=8)"
