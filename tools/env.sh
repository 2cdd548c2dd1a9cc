#!/bin/bash
# Print export lines with which a plain qgis_process sees the plugin and its packages.
# Use: eval "$(make env)"
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
profile=$root/build/profile
settings=$profile/profiles/default/QGIS
for name in QGIS3.ini QGIS4.ini; do
  if [ ! -e "$settings/$name" ]; then
    mkdir -p "$settings"
    printf '[PythonPlugins]\nskyline_viewshed=true\nprocessing=true\n' > "$settings/$name"
  fi
done
mkdir -p -m 700 "$root/build/run"
# Debian's wrapper of 3.22 hands qgis_process an option that it refuses; go past it where the program itself is there.
mkdir -p "$root/build/bin"
if command -v qgis_process.bin > /dev/null; then
  printf '#!/bin/sh\nexec qgis_process.bin "$@"\n' > "$root/build/bin/qgis_process"
  chmod +x "$root/build/bin/qgis_process"
else
  rm -f "$root/build/bin/qgis_process"
fi
packages=$("$root/.venv/bin/python" -c 'import sysconfig; print(sysconfig.get_paths()["purelib"])')
cat <<EOF
export QGIS_PLUGINPATH='$root/build/plugins'
export PYTHONPATH='$packages'
export QGIS_CUSTOM_CONFIG_PATH='$profile'
export QT_QPA_PLATFORM='offscreen'
export XDG_RUNTIME_DIR='$root/build/run'
export PATH='$root/build/bin':"\$PATH"
export OMP_NUM_THREADS='1'
export OPENBLAS_NUM_THREADS='1'
EOF
