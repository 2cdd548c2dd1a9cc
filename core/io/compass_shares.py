"""The file that keeps the result of a test of compasses, so that a repeated run need not test them again."""

from __future__ import annotations

import json
from pathlib import Path

from ..base.errors import OutputError
from .whole_file import staged


def read_shares(path):
    """Read the result of `joint.trust.shares_of` from a file; None if it does not exist or is damaged."""
    try:
        return tuple(
            (str(camera), float(share)) for camera, share in json.loads(Path(path).read_text(encoding="utf-8"))
        )
    except (OSError, ValueError, TypeError):
        return None


def write_shares(path, shares):
    """Write the result of `joint.trust.shares_of` to a file, whole or not at all; creates its folder.

    Raises
    ------
    OutputError
    """
    path = Path(path)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise OutputError.of_file(path, error.strerror or str(error)) from None
    with staged(path) as stage:
        (stage / path.name).write_text(json.dumps(shares), encoding="utf-8")
