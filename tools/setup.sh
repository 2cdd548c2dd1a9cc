#!/bin/bash
# Make a machine ready for make demo and make test: system packages, then .venv. Quick when nothing is missing.
#
# The virtual environment stands on the system's Python, because QGIS's Python modules belong to it, and pins
# NumPy to the system's version, because QGIS's GDAL bindings are built against that one.
set -euo pipefail
cd "$(dirname "$0")/.."

PACKAGES="python3-scipy python3-pil python3-venv python3-pip qttools5-dev-tools git make curl"
# With SKYLINE_SYSTEM_QGIS=1 the machine has a QGIS already (a container of the QGIS project), which apt must not replace.
if [ "${SKYLINE_SYSTEM_QGIS:-0}" != 1 ]; then
  PACKAGES="qgis python3-qgis python3-gdal gdal-bin python3-numpy $PACKAGES"
fi
SYSTEM_PYTHON=/usr/bin/python3
STAMP=.venv/.skyline-setup

say() { printf '%s\n' "$*" >&2; }

missing_packages() {
  command -v dpkg-query > /dev/null || return 0
  for package in $PACKAGES; do
    dpkg-query -W -f='${Status}' "$package" 2> /dev/null | grep -q '^install ok installed' || printf '%s ' "$package"
  done
}

install_packages() {
  local missing sudo=""
  missing=$(missing_packages)
  [ -z "$missing" ] && return
  if [ "$(id -u)" -ne 0 ]; then
    if command -v sudo > /dev/null; then sudo="sudo"; else
      say "These system packages are missing: $missing"
      say "Install them as root (apt-get install $missing) and repeat."
      exit 1
    fi
  fi
  say "Installing system packages: $missing"
  local log=build/apt.log
  if ! { $sudo env DEBIAN_FRONTEND=noninteractive apt-get update -qq &&
         $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing; } > $log 2>&1
  then
    tail -n 20 $log >&2
    say "The system packages could not be installed; the whole log is in $log."
    exit 1
  fi
}

make_venv() {
  # A venv of another Python, or one moved from elsewhere, cannot see QGIS.
  if [ -e .venv ] && ! .venv/bin/python -c 'import sys; sys.exit(sys.base_prefix != "/usr")' 2> /dev/null; then
    say "Replacing .venv: it does not stand on $SYSTEM_PYTHON"
    rm -rf .venv
  fi
  [ -x .venv/bin/python ] || $SYSTEM_PYTHON -m venv --system-site-packages .venv
  local numpy
  numpy=$($SYSTEM_PYTHON -c 'import numpy; print(numpy.__version__)')
  say "Installing Python packages into .venv (numpy $numpy as on the system)"
  .venv/bin/python -m pip install -q --disable-pip-version-check "numpy==$numpy" -r requirements-dev.txt
}

fingerprint() {
  { cat tools/setup.sh requirements-dev.txt; pwd; $SYSTEM_PYTHON -c 'import sys, numpy; print(sys.version, numpy.__version__)'; } |
    sha256sum | cut -d ' ' -f 1
}

mkdir -p build
install_packages
if [ "$(cat $STAMP 2> /dev/null)" != "$(fingerprint)" ]; then
  make_venv
  fingerprint > $STAMP
fi
if ! $SYSTEM_PYTHON -c 'import qgis.core' 2> /dev/null; then
  say "QGIS's Python modules cannot be imported by $SYSTEM_PYTHON. On Debian or Ubuntu install python3-qgis."
  exit 1
fi
