#!/bin/bash
# Make a Debian tree with what a minimal machine has, and git and make: tools/qgis_root.sh SUITE DIR [backports]
#
# QGIS itself is left to tools/setup.sh, as on a user's machine; with "backports" it will come from there. A tree that
# is finished is left as it is. Package mirror, certificates and pip settings are those of this machine.
set -euo pipefail
suite=$1
tree=$2
backports=${3:-}
here=$(dirname "$0")
[ -e "$tree/.finished" ] && exit 0

say() { printf '%s\n' "$*" >&2; }

if [ "$(id -u)" -ne 0 ]; then say "A Debian tree can only be made by root: repeat with sudo."; exit 1; fi
if ! command -v debootstrap > /dev/null; then say "debootstrap is missing: apt-get install debootstrap"; exit 1; fi
mirror=$({ cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2> /dev/null || true; } |
  awk '/^URIs:/ { print $2; exit } /^deb / { for (i = 2; i <= NF; i++) if ($i ~ /^https?:/) { print $i; exit } }')
if [ -z "$mirror" ]; then say "No Debian mirror is set up in /etc/apt."; exit 1; fi

say "Making Debian $suite${backports:+ with backports} in $tree"
rm -rf "$tree"
mkdir -p "$tree"
if ! debootstrap --variant=minbase --include=ca-certificates,git,make "$suite" "$tree" "$mirror" > "$tree.log" 2>&1; then
  tail -n 20 "$tree.log" >&2
  say "debootstrap failed; its log is $tree.log."
  exit 1
fi
: > "$tree/etc/apt/sources.list"
for archive in "$suite" ${backports:+"$suite-backports"}; do
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $archive main"
done > "$tree/etc/apt/sources.list.d/debian.list"
if [ -n "$backports" ]; then
  printf 'Package: *\nPin: release n=%s-backports\nPin-Priority: 990\n' "$suite" > "$tree/etc/apt/preferences.d/backports"
fi
echo 'Acquire::Check-Valid-Until "false";' > "$tree/etc/apt/apt.conf.d/90valid"   # a mirror may be a snapshot
printf '#!/bin/sh\nexit 101\n' > "$tree/usr/sbin/policy-rc.d"                     # start no services
chmod +x "$tree/usr/sbin/policy-rc.d"
cp /etc/resolv.conf "$tree/etc/"
for setting in /etc/pip.conf /etc/ssl/certs/ca-certificates.crt; do
  [ -e "$setting" ] && cp -f "$setting" "$tree$setting"
done
"$here/in_root.sh" "$tree" apt-get update -qq
touch "$tree/.finished"
