#!/bin/bash
# Put build/skyline_viewshed.zip into the default QGIS profile of this user (QGIS 3, else QGIS 4).
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
case "$(uname -s)" in
  Darwin) base="$HOME/Library/Application Support/QGIS" ;;
  *) base="${XDG_DATA_HOME:-$HOME/.local/share}/QGIS" ;;
esac
if [ -d "$base/QGIS4" ] && [ ! -d "$base/QGIS3" ]; then series=QGIS4; else series=QGIS3; fi
plugins="$base/$series/profiles/default/python/plugins"
mkdir -p "$plugins"
rm -rf "$plugins/skyline_viewshed"
"$root/.venv/bin/python" -m zipfile -e "$root/build/skyline_viewshed.zip" "$plugins"
echo "Installed in $plugins/skyline_viewshed."
echo "Start QGIS, tick Skyline Viewshed in Plugins > Manage and Install Plugins, and open the Processing toolbox."
