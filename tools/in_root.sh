#!/bin/bash
# Run a command inside a Debian tree: tools/in_root.sh DIR COMMAND...
#
# READ_ONLY="host:inside host:inside" shows folders of this machine inside, read-only. All mounts live in a private mount
# namespace, so none outlives the command and the tree can be deleted safely. The environment starts empty: the tree
# sees what a user's login on such a machine sees.
set -euo pipefail
tree=$(cd "$1" && pwd)
shift
READ_ONLY=${READ_ONLY:-} exec unshare --mount --propagation private bash -euc '
  tree=$1
  shift
  for name in proc dev sys; do mount --bind /$name "$tree/$name"; done
  for pair in $READ_ONLY; do
    mkdir -p "$tree${pair#*:}"
    mount --bind "${pair%%:*}" "$tree${pair#*:}"
    mount -o remount,bind,ro "$tree${pair#*:}"
  done
  exec chroot "$tree" env -i HOME=/root USER=root LANG=C.UTF-8 PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin "$@"
' in_root "$tree" "$@"
