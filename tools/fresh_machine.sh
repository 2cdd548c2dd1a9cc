#!/bin/bash
# Prove the README's two commands where nothing was prepared: a new minimal Debian 12 with git and make, a clone of the
# last commit, then make demo and make test. No shared data are there, as with a newcomer. Needs root and debootstrap.
#
# tools/fresh_machine.sh [TARGET...]     (demo and test where none is named)
set -euo pipefail
cd "$(dirname "$0")/.."
ROOTS=${ROOTS:-/var/tmp/skyline-roots}
tree=$ROOTS/fresh
mkdir -p "$ROOTS" build
tools/qgis_root.sh bookworm "$ROOTS/minimal"
rm -rf "$tree"
cp -a "$ROOTS/minimal" "$tree"
export READ_ONLY="$(git rev-parse --path-format=absolute --git-common-dir):/mnt/repository.git"
tools/in_root.sh "$tree" git clone -q /mnt/repository.git /root/skyline_viewshed < /dev/null
for target in "${@:-demo test}"; do
  for one in $target; do
    started=$SECONDS
    echo "== make $one on a fresh machine"
    tools/in_root.sh "$tree" make -C /root/skyline_viewshed "$one" < /dev/null
    echo "== make $one succeeded after $((SECONDS - started)) s"
  done
done
