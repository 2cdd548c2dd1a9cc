"""Files that each store the orientation of one photograph, so that a repeated run need not compute it again.

The file is a NumPy archive of the arrays, with all other values as JSON, so that reading it executes no code. It
contains a fingerprint of everything on which the answer depends.
"""

from __future__ import annotations

import hashlib
import io
import json
import zipfile
import zlib
from dataclasses import fields, replace
from datetime import datetime
from functools import lru_cache
from pathlib import Path

import numpy as np

from ..base.camera import Camera, Pose
from ..base.messages import Message
from ..base.model import Candidate, HorizonProfile, Orientation, OrientedPhoto, PhotoMetadata, Skyline, SkylineEvidence
from ..base.uncertainty import PoseUncertainty
from .file_state import file_state

CORE = Path(__file__).resolve().parent.parent
PROGRAM = (".py", ".json", ".txt", ".npz")
"""Files on which answers depend: code, tables, and the sky network."""
NOT_DRAWN = "sky_score", "ridge_score", "sky_map", "rival"
"""Parts of the evidence that the report does not draw."""
KINDS = {
    kind.__name__: kind
    for kind in (
        Camera, Candidate, HorizonProfile, Orientation, OrientedPhoto, PhotoMetadata, Pose, PoseUncertainty, Skyline,
        SkylineEvidence,
    )
}  # fmt: skip
UNREADABLE = OSError, ValueError, KeyError, TypeError, AttributeError, EOFError, zipfile.BadZipFile, zlib.error


def orientation_mark(request, dem, options):
    """Make a digest of all on which an orientation depends: photo and DEM files, request, options, and the program.

    Changed files are detected by size and modification time, as `make` does. A changed program is detected by its
    source, because answers differ a little between versions.

    Parameters
    ----------
    request : core.batch.PhotoRequest
    dem : Dem
    options : core.pipeline.OrientOptions
        All other options that affect the answer; compared by their `repr`.
    """
    facts = [_program(), *map(file_state, (request.path, request.sky_mask_path)), dem.state, request, options]
    return hashlib.sha256(repr(facts).encode("utf-8", "surrogateescape")).hexdigest()[:32]


@lru_cache(maxsize=1)
def _program():
    digest = hashlib.sha256()
    for path in sorted(path for path in CORE.rglob("*") if path.suffix in PROGRAM):
        digest.update(path.relative_to(CORE).as_posix().encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()


def packed(oriented, mark):
    """Give the content of the file for one photograph's orientation as bytes.

    Of the evidence only what the report draws is kept, because the rest would double the size.

    Parameters
    ----------
    oriented : OrientedPhoto
    mark : str
        Fingerprint from `orientation_mark`.
    """
    if oriented.evidence is not None:
        oriented = replace(oriented, evidence=replace(oriented.evidence, **dict.fromkeys(NOT_DRAWN)))
    arrays = {}
    tree = {"mark": mark, "photo": _plain(oriented, arrays)}
    target = io.BytesIO()
    np.savez_compressed(target, tree=np.frombuffer(json.dumps(tree).encode(), np.uint8), **arrays)
    return target.getvalue()


def holds(path, mark):
    """Tell whether a file has this fingerprint, without reading its arrays; they may still be damaged."""
    try:
        with open(path, "rb") as file, np.load(file, allow_pickle=False) as archive:
            return json.loads(archive["tree"].tobytes())["mark"] == mark
    except UNREADABLE:
        return False


def unpacked(path, mark):
    """Read the `OrientedPhoto` of a file that is complete and has this fingerprint; else None."""
    try:
        # Opened here, because np.load leaves a damaged file open.
        with open(path, "rb") as file, np.load(file, allow_pickle=False) as archive:
            tree = json.loads(archive["tree"].tobytes())
            return _restored(tree["photo"], archive) if tree["mark"] == mark else None
    except UNREADABLE:
        return None


def _plain(value, arrays):
    """Convert a value to JSON types; arrays are added to `arrays` and replaced by their names."""
    if isinstance(value, np.ndarray):
        name = f"array_{len(arrays)}"
        arrays[name] = value
        return {"array": name}
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, (tuple, list)):
        return [_plain(item, arrays) for item in value]
    if isinstance(value, datetime):
        return {"time": value.isoformat()}
    if isinstance(value, Message):  # kept as a template, since the next run may be in another language
        return {"message": value.template, "facts": {name: _plain(fact, arrays) for name, fact in value.facts.items()}}
    if type(value).__name__ in KINDS:
        return {"kind": type(value).__name__, **{f.name: _plain(getattr(value, f.name), arrays) for f in fields(value)}}
    return value


def _restored(value, arrays):
    """Invert `_plain`; every list becomes a tuple."""
    if isinstance(value, list):
        return tuple(_restored(item, arrays) for item in value)
    if not isinstance(value, dict):
        return value
    if "array" in value:
        return arrays[value["array"]]
    if "time" in value:
        return datetime.fromisoformat(value["time"])
    if "message" in value and "kind" not in value:
        return Message.restored(
            value["message"], {name: _restored(fact, arrays) for name, fact in value["facts"].items()}
        )
    return KINDS[value["kind"]](**{name: _restored(item, arrays) for name, item in value.items() if name != "kind"})
