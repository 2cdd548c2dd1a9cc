"""A slope for tests of rasters."""

from __future__ import annotations

import numpy as np
import pytest


@pytest.fixture
def hills():
    rows, cols = np.mgrid[0:60, 0:80]
    return (1500 + 20 * rows + 3 * cols).astype(np.float32)
