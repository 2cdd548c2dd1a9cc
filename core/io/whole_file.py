"""Write files in a hidden folder under their final names, and move them into place once they are complete.

This is for writers that take a name instead of a handle, such as those of vector layers: the layer in the file is
named after the file, and some formats consist of several files. A process that is killed leaves the hidden folder, but
never an incomplete file under the final name.
"""

from __future__ import annotations

import errno
import os
import secrets
import shutil
import time
from contextlib import contextmanager, suppress
from pathlib import Path

from ..base.errors import OutputError
from ..base.messages import Message

JOURNALS = ("-wal", "-shm", "-journal")
"""Suffixes of the files that SQLite keeps beside a database; those of a killed process must not meet a new database."""

PATIENCE_S = (0.1, 0.4)

SHAPEFILE_PARTS = (".shx", ".dbf", ".prj", ".cpg", ".qix", ".sbn", ".sbx", ".qpj", ".idm", ".ind")
"""Suffixes of the files of an older shapefile of the same name, which QGIS too removes when it overwrites one."""


@contextmanager
def staged(path):
    """Yield a folder to write in; its files move to the folder of `path` if the block ends without an error.

    Parameters
    ----------
    path : str or Path
        Final path of the file; its folder must exist.

    Yields
    ------
    Path
        New hidden folder on the same file system, so that moving is atomic. The file in it may have a suffix that
        `path` does not have.

    Raises
    ------
    OutputError
        If the folder is missing or read-only, or an older file of that name cannot be replaced.
    """
    path = Path(path)
    stage = path.with_name(f".skyline-{secrets.token_hex(6)}")
    try:
        try:
            stage.mkdir()
            yield stage
            _move(stage, path)
        except OSError as error:
            raise _output_error(path, error) from None
    finally:
        shutil.rmtree(stage, ignore_errors=True)


def check_folder(path):
    """Refuse before a long run what could not be written after it; raises `ValueError`."""
    folder = Path(path).parent
    if not folder.is_dir() or not os.access(folder, os.W_OK):
        raise ValueError(f"{path} cannot be written: the folder {folder} does not exist or is read-only")


def unused_name(stem, taken):
    """Give a name that is not yet in the set `taken`, and add it in lower case."""
    name, number = stem, 2
    while name.lower() in taken:
        name, number = f"{stem}_{number}", number + 1
    taken.add(name.lower())
    return name


def _move(stage, path):
    """Move a single file atomically; with companion files, the main name stays unused until they are in place."""
    written = sorted(stage.iterdir(), key=lambda file: file.name.startswith(path.name))
    if not written:
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT))
    main = path.with_name(written[-1].name)
    stale = [file for file in _companions(main) if os.path.lexists(file)]
    if stale or len(written) > 1:
        with suppress(FileNotFoundError):
            main.unlink()
        for file in stale:
            file.unlink()
    for file in written:
        _replace(file, path.with_name(file.name))


def _replace(file, target):
    """Rename a file, with retries, because on Windows a virus scanner may lock a new file for a moment."""
    for seconds in PATIENCE_S:
        try:
            os.replace(file, target)
            return
        except PermissionError:
            time.sleep(seconds)
    os.replace(file, target)


def _companions(main):
    parts = SHAPEFILE_PARTS if main.suffix.lower() == ".shp" else ()
    return [main.with_name(main.name + end) for end in JOURNALS] + [main.with_suffix(end) for end in parts]


def _output_error(path, error):
    reason = error.strerror or str(error)
    if not path.parent.is_dir():
        reason = Message("the folder {folder} does not exist", folder=path.parent)
    return OutputError.of_file(path, reason)
