"""The Python that runs workers, and how many of them there are.

Inside QGIS on Windows and macOS `sys.executable` is QGIS itself, and starting that would open a second QGIS. Only files
whose name begins with "python" are therefore ever started.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

WORKER_BYTES = 700 * 2**20
"""Memory that one worker may take; fewer workers are started where less is free."""

FEWEST_TASKS = 4
"""With fewer photographs than this, starting workers is not worth its time unless their number was asked for."""


def interpreters(executable=None, prefixes=None, windows=None):
    """List the files that may be this program's Python, the most likely first.

    Parameters
    ----------
    executable : str or None
        None takes `sys.executable`.
    prefixes : iterable of str or None
        Folders of the installation; None takes those of this Python, and OSGeo4W's.
    windows : bool or None
        None looks at `sys.platform`.

    Returns
    -------
    list of str
        Existing files, each once.
    """
    executable = Path((sys.executable if executable is None else executable) or "")
    windows = sys.platform == "win32" if windows is None else windows
    if prefixes is None:
        prefixes = [sys.exec_prefix, sys.base_exec_prefix, os.environ.get("OSGEO4W_ROOT", "")]
    names = [f"python{sys.version_info[0]}.{sys.version_info[1]}", "python3", "python"]
    names = [f"{name}.exe" for name in ("python", "python3")] if windows else names
    found = [executable] if executable.name.lower().startswith("python") else []
    folders = [executable.parent] if executable.name else []
    folders += [Path(prefix) for prefix in prefixes if prefix]
    found += [folder / part / name for folder in folders for part in ("", "bin", "../bin") for name in names]
    return list(dict.fromkeys(str(path) for path in found if path.is_file()))


def worker_count(wanted, tasks, cores=None, free_bytes=None):
    """Decide how many processes work; 1 means that this process does all of it.

    Parameters
    ----------
    wanted : int
        0 means all cores but one, as far as there is memory for them.
    tasks : int
        Number of photographs.
    cores, free_bytes : int or None
        None asks the system.
    """
    if wanted != 0:
        return max(min(wanted, tasks), 1)
    if tasks < FEWEST_TASKS:
        return 1
    cores = _cores() if cores is None else cores
    free_bytes = _free_bytes() if free_bytes is None else free_bytes
    fitting = cores if free_bytes is None else free_bytes // WORKER_BYTES
    return int(max(min(cores - 1, fitting, tasks), 1))


def _cores():
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _free_bytes():
    """Memory that is free or can be freed at once; None where the system does not say [bytes]."""
    try:
        with open("/proc/meminfo", encoding="ascii") as table:
            for line in table:
                if line.startswith("MemAvailable:"):
                    return 1024 * int(line.split()[1])
    except (OSError, ValueError):
        pass
    return None
