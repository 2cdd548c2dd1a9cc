"""Folders of NumPy arrays that are too large for the memory: filled on disk, and read without being loaded."""

from __future__ import annotations

import hashlib
import os
import secrets
import shutil
from contextlib import contextmanager, suppress
from pathlib import Path

import numpy as np

from ..base.errors import OutputError

UNREADABLE = OSError, ValueError, EOFError


def mark_of(dem, *facts):
    """Make a digest of a DEM, as its files and the user's choices give it, and of further facts, by their `repr`.

    Parameters
    ----------
    dem : core.io.raster.Dem
    *facts
        Values whose `repr` tells them apart.
    """
    return hashlib.sha256(repr((dem.state, facts)).encode("utf-8", "surrogateescape")).hexdigest()[:32]


class ArrayFolder:
    """A folder of arrays, which appears complete or not at all.

    Parameters
    ----------
    path : str or Path
        The folder; its parent is created if it is missing.
    """

    def __init__(self, path):
        self.path = Path(path)

    def read(self, names):
        """Open the arrays of these names as a dict, without loading them; None if they are not all there."""
        try:
            return {name: np.load(self.path / f"{name}.npy", mmap_mode="r", allow_pickle=False) for name in names}
        except UNREADABLE:
            return None

    @contextmanager
    def filling(self):
        """Yield a function (name, shape, dtype) -> array on disk; the folder appears when the block ends well.

        Raises
        ------
        OutputError
            The folder cannot be written.
        """
        part = self.path.with_name(f".skyline-{secrets.token_hex(6)}")
        held = []

        def hold(name, shape, dtype):
            array = np.lib.format.open_memmap(part / f"{name}.npy", mode="w+", dtype=dtype, shape=shape)
            held.append(array)
            return array

        try:
            part.mkdir(parents=True)
            yield hold
            for array in held:
                array.flush()
            held.clear()
            with suppress(FileNotFoundError):
                shutil.rmtree(self.path)
            os.replace(part, self.path)
        except OSError as error:
            raise OutputError.of_file(self.path, error.strerror or str(error)) from None
        finally:
            held.clear()
            shutil.rmtree(part, ignore_errors=True)
