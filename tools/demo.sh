#!/bin/bash
# make demo: the environment of make env around tools/demo.py.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
eval "$("$root/tools/env.sh")"
arguments=()
if [ -n "${PHOTOS:-}" ] || [ -n "${DEM:-}" ]; then
  arguments=(--photos "${PHOTOS:-}" --dem "${DEM:-}")
fi
export PYTHONPATH="$root/build/plugins:$PYTHONPATH"
exec "$root/.venv/bin/python" "$root/tools/demo.py" "$root/build/demo" "${arguments[@]}"
