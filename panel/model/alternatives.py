"""Further answers for a photograph: the second and third heading of the table, put onto the extracted skyline."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from ...core.base.camera import Pose
from .identity import same
from .solving import levelled_draft


class Alternatives:
    """Remembers the answers as long as nothing on which they depend changes, since they are drawn in every frame."""

    def __init__(self):
        self._for: tuple[Any, ...] = ()
        self._found: tuple[Any, ...] = ()

    def of(self, session):
        """Give the answers for a session: ((number, Pose), ...); the same tuple as long as they are the same."""
        if session.item is None or session.ground is None or session.draft is None:
            return ()
        present = session.item, session.draft.camera, session.ground, session.evidence
        if not same(self._for, present):
            self._for, self._found = present, tuple(_answers(session))
        return self._found


def _answers(session):
    for number in (2, 3):
        heading = session.item.values[f"heading_{number}"]
        if heading is not None:
            base = session.item.pose or Pose(heading)
            draft = replace(session.draft, pose=replace(base, heading_deg=heading))
            yield number, levelled_draft(draft, session.ground, session.evidence).pose
