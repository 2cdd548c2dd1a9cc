"""Find, install and run the programs that the engine is compared with, and time whole processes."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

CURVATURE = str(6 / 7)
"""GDAL's curvature coefficient: 1 - k for k = 1/7, which r.viewshed uses as its refraction coefficient."""


class PeerMissingError(Exception):
    """A peer program is not available; the message gives the reason."""


@dataclass(frozen=True)
class Run:
    """Finished process: wall and processor time [s], and largest resident memory of it and its children [MB]."""

    wall_s: float
    cpu_s: float
    memory_mb: float


LAUNCHER = """
import json, os, sys, time
start = time.perf_counter()
pid = os.posix_spawnp(sys.argv[1], sys.argv[1:], os.environ)
_, status, usage = os.wait4(pid, 0)
wall = time.perf_counter() - start
print(json.dumps([os.waitstatus_to_exitcode(status), wall, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024]))
"""
"""Small process between this one and the one to be measured: a child counts its parent's memory as its own until it has
started, and this process may be large."""


def timed(command, **options):
    """Run a command to its end and measure it; raise `PeerMissingError` with the end of its output if it fails."""
    words = [sys.executable, "-S", "-c", LAUNCHER, *(str(word) for word in command)]
    done = subprocess.run(words, capture_output=True, text=True, check=False, **options)
    last = done.stdout.strip().splitlines()[-1:]
    if not last or not last[0].startswith("["):
        raise PeerMissingError(f"{command[0]} could not be started: {done.stderr.strip()[-200:]}")
    code, wall, cpu, memory = json.loads(last[0])
    if code != 0:
        raise PeerMissingError(f"{command[0]} failed with {code}: {done.stderr.strip()[-200:]}")
    return Run(wall, cpu, memory)


def engine(*arguments):
    """Run our own engine as a process with Debian's Python, NumPy and GDAL."""
    root = Path(__file__).resolve().parent.parent
    environment = dict(os.environ, PYTHONPATH=str(root / "build" / "plugins"), OMP_NUM_THREADS="1")
    return timed([sys.executable, root / "benchmarks" / "engine_run.py", *arguments], env=environment)


def gdal_viewshed(dem, x, y, radius_m, output):
    """Run GDAL's command line viewshed, which always covers the full circle."""
    if shutil.which("gdal_viewshed") is None:
        raise PeerMissingError("gdal_viewshed is not installed (package gdal-bin)")
    remove(output)
    words = ["-q", "-oz", 1.7, "-tz", 0, "-md", radius_m, "-ox", x, "-oy", y, "-cc", CURVATURE, dem, output]
    return timed(["gdal_viewshed", *words])


class NewerGdal:
    """Newer GDAL, which can limit a viewshed to a wedge; bundled in a wheel, in its own environment."""

    def __init__(self, folder):
        folder = Path(folder)
        self.python = folder / "bin" / "python"
        if not self.python.exists():
            _install([sys.executable, "-m", "venv", folder])
        if not list(folder.rglob("pyogrio.libs/libgdal*")):
            _install([self.python, "-m", "pip", "install", "-q", "--no-deps", "pyogrio"])
        found = list(folder.rglob("pyogrio.libs/libgdal*"))
        if not found:
            raise PeerMissingError("the wheel of pyogrio holds no GDAL library")
        self.library = found[0]
        version = ".".join(self.library.name.split(".")[-3:])
        if tuple(map(int, version.split("."))) < (3, 12):
            raise PeerMissingError(f"the wheel of pyogrio holds GDAL {version}, which has no wedge")
        self.version = version

    def wedge(self, dem, x, y, radius_m, start_deg, end_deg, output):
        """Compute the viewshed of a wedge, clockwise from start to end."""
        words = ["--position", f"{x},{y},1.7", "--target-height", 0, "--max-distance", radius_m]
        words += ["--curvature-coefficient", CURVATURE, "--start-angle", start_deg, "--end-angle", end_deg]
        script = Path(__file__).with_name("gdal_wheel_run.py")
        return timed([self.python, script, self.library, *words, "--overwrite", dem, output])


class Grass:
    """GRASS GIS in its own location, with the DEMs linked."""

    def __init__(self, folder):
        if shutil.which("grass") is None:
            if os.geteuid() != 0 or shutil.which("apt-get") is None:
                raise PeerMissingError("GRASS is not installed (package grass-core)")
            _install(["apt-get", "install", "-y", "--no-install-recommends", "grass-core"])
        self.folder = Path(folder)

    def _mapset(self, dem):
        location = self.folder / Path(dem).stem
        if not location.exists():
            location.parent.mkdir(parents=True, exist_ok=True)
            _install(["grass", "-c", dem, location, "-e"])
            _install(["grass", location / "PERMANENT", "--exec", "r.external", f"input={dem}", "output=dem"])
            _install(["grass", location / "PERMANENT", "--exec", "g.region", "raster=dem"])
        return location / "PERMANENT"

    def horizon(self, dem, x, y, radius_m, output):
        """Compute 3,600 azimuths from one place; r.horizon has neither eye height nor refraction."""
        words = ["r.horizon", "-d", "elevation=dem", f"coordinates={x},{y}", "step=0.1", "start=0", "end=360"]
        words += [f"maxdistance={radius_m}", "distance=1.0", f"file={output}", "--overwrite"]
        return timed(["grass", self._mapset(dem), "--exec", *words])

    def viewshed(self, dem, x, y, radius_m):
        """Compute the viewshed of the full circle."""
        words = ["r.viewshed", "-b", "-c", "-r", "input=dem", "output=seen", f"coordinates={x},{y}", "--overwrite"]
        words += ["observer_elevation=1.7", "target_elevation=0", f"max_distance={radius_m}"]
        return timed(["grass", self._mapset(dem), "--exec", *words, f"refraction_coeff={1 / 7}", "memory=4000"])


def remove(path):
    """Delete a file if it exists."""
    if os.path.exists(path):
        os.remove(path)


def _install(command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise PeerMissingError(f"{' '.join(map(str, command[:4]))} failed: {done.stderr.strip()[-200:]}")
