#!/bin/bash
# make screenshots: QGIS with a desktop of its own under Xvfb, on the demo's sample; pictures go to docs/images.
#
# Needs Xvfb and openbox (apt-get install --no-install-recommends xvfb openbox), and Chromium for the report.
set -euo pipefail
cd "$(dirname "$0")/../.."
for program in Xvfb openbox; do
  command -v $program > /dev/null || { echo "$program is missing. Run: apt-get install xvfb openbox"; exit 1; }
done
root=$PWD
work=$root/build/screenshots
rm -rf "$work" && mkdir -p "$work/raw" "$work/results"
[ -e build/demo/sample/truth.csv ] || .venv/bin/python tools/make_sample.py build/demo/sample
eval "$(tools/env.sh)"
unset QGIS_CUSTOM_CONFIG_PATH
settings=$work/profiles/default/QGIS
mkdir -p "$settings"
printf '%s\n' '[PythonPlugins]' 'skyline_viewshed=true' 'processing=true' '' '[qgis]' 'checkVersion=false' \
  'firstRunVersionFlag=99900' 'showTips=false' > "$settings/QGIS3.ini"
cp "$settings/QGIS3.ini" "$settings/QGIS4.ini"

number=90
while [ -e /tmp/.X$number-lock ]; do number=$((number + 1)); done
Xvfb :$number -screen 0 1320x840x24 -nolisten tcp > "$work/xvfb.log" 2>&1 &
server=$!
sleep 1
export DISPLAY=:$number
openbox > "$work/openbox.log" 2>&1 &
manager=$!
trap 'kill $manager $server 2> /dev/null || true' EXIT

export QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 SHOTS="$work" SAMPLE="$root/build/demo/sample" LC_ALL=C.UTF-8
program=$(command -v qgis.bin || command -v qgis)
timeout 400 "$program" --nologo --noversioncheck --profiles-path "$work" --profile default \
  --code "$root/tools/screenshots/desktop.py" < /dev/null > "$work/qgis.log" 2>&1 || true
cat "$work/desktop.log"
PYTHONPATH=build/plugins .venv/bin/python tools/screenshots/panel_points.py "$SAMPLE" "$work/points.gpkg"
SHOTS=$work PANEL_POINTS=$work/points.gpkg PANEL_DEM=$SAMPLE/dem/mountains.tif PANEL_ROOT=$root PANEL_FIRST=morning timeout 400 "$program" \
  --nologo --noversioncheck --profiles-path "$work" --profile default --code "$root/tools/screenshots/panel.py" \
  < /dev/null > "$work/qgis_panel.log" 2>&1 || true
cat "$work/panel.log"
.venv/bin/python tools/screenshots/publish.py "$work" docs/images
PYTHONPATH=build/plugins .venv/bin/python tools/screenshots/failures.py "$SAMPLE" docs/images/failures.png
PYTHONPATH=build/plugins .venv/bin/python tools/screenshots/ground.py "$SAMPLE" docs/images/ground.png
