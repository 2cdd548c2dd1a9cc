#!/bin/bash
# Run the whole suite on several QGIS versions, each in a Debian tree of its own, and print a table.
#
# tools/test_matrix.sh [bookworm|trixie|trixie-backports]...     (all three where none is named; needs root, debootstrap)
# What is tested is the last commit, set up by tools/setup.sh as on a user's machine. JOBS versions run at the same time
# (one for each core). The trees (about 3 GB each) stay in ROOTS for the next time. SKYLINE_DATA shows the shared real
# data to the tests; PYTEST_ARGS reaches pytest. Logs: build/matrix.
set -euo pipefail
cd "$(dirname "$0")/.."
ROOTS=${ROOTS:-/var/tmp/skyline-roots}
DATA=${SKYLINE_DATA:-$PWD/../shared/data}
CHECKOUT=/root/skyline_viewshed
mkdir -p "$ROOTS" build/matrix
READ_ONLY="$(git rev-parse --path-format=absolute --git-common-dir):/mnt/repository.git"
[ -d "$DATA" ] && READ_ONLY="$READ_ONLY $(cd "$DATA" && pwd):/root/shared/data"
export READ_ONLY
commit=$(git rev-parse HEAD)

versions='
import sys, numpy, scipy
from osgeo import gdal
from qgis.core import Qgis
from qgis.PyQt.QtCore import QT_VERSION_STR
try:
    import cv2
    opencv = cv2.__version__
except ImportError:
    opencv = "none"
print(Qgis.QGIS_VERSION.split("-")[0], QT_VERSION_STR, sys.version.split()[0], gdal.__version__, numpy.__version__,
      scipy.__version__, opencv, sep=" | ")'

run_in() {
  local name=$1 tree=$ROOTS/$1 log=$PWD/build/matrix/$1.log started=$SECONDS result=0
  tools/qgis_root.sh "${name%-backports}" "$tree" "$([[ $name == *-backports ]] && echo backports)" || return 1
  # shellcheck disable=SC2016
  tools/in_root.sh "$tree" bash -euc '
    [ -d "$1/.git" ] || git clone -q --no-checkout /mnt/repository.git "$1"
    cd "$1"
    git fetch -q /mnt/repository.git "$2"
    git checkout -q -f --detach "$2"
    rm -f build/tests.xml
    nice make test PYTEST_ARGS="--junitxml=build/tests.xml $3"
  ' run "$CHECKOUT" "$commit" "${PYTEST_ARGS:-}" > "$log" 2>&1 < /dev/null || result=$?
  local facts counts
  facts=$(tools/in_root.sh "$tree" "$CHECKOUT/.venv/bin/python" -c "$versions" 2> /dev/null) || facts="- | - | - | - | - | - | -"
  counts=$(grep -E '^(=+ )?[0-9]+ (passed|failed|error).* in ' "$log" | tail -n 1 | tr -d '=' | xargs) || true
  printf '| %s | %s | %s | %s min |\n' "$name" "$facts" "${counts:-no result, see $log}" "$(((SECONDS - started + 59) / 60))" \
    > "build/matrix/$name.row"
  return "$result"
}

names=()
for name in "${@:-bookworm trixie trixie-backports}"; do
  for one in $name; do names+=("$one"); done
done
rm -f build/matrix/*.row
failed=0 running=0
for one in "${names[@]}"; do
  # nproc heeds OMP_NUM_THREADS, which make sets to 1; --all does not.
  if [ "$running" -ge "${JOBS:-$(nproc --all)}" ]; then wait -n || failed=1; running=$((running - 1)); fi
  run_in "$one" &
  running=$((running + 1))
done
while [ "$running" -gt 0 ]; do wait -n || failed=1; running=$((running - 1)); done
{
  echo "| Debian | QGIS | Qt | Python | GDAL | NumPy | SciPy | OpenCV | tests | with set-up |"
  echo "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
  for one in "${names[@]}"; do cat "build/matrix/$one.row" 2> /dev/null || echo "| $one | no tree: see the messages above |"; done
} > build/matrix/table.md
cat build/matrix/table.md
for one in "${names[@]}"; do grep -HE '^(FAILED|ERROR) ' "build/matrix/$one.log" || true; done
exit "$failed"
