#!/usr/bin/env bash
# Installs the packages of build/packages on a bare Debian and tries them there. As root; needs
# mmdebstrap, and packages of Debian as the system fetches them.
# SPDX-License-Identifier: GPL-2.0-or-later
#
# usage: try_in_chroot.sh PACKAGES SUITE [TAR]    # TAR: a bare system, kept for the next time
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
packages=$(cd "$1" && pwd -P)
suite=$2
[ "$(id -u)" = 0 ] || { echo "error: chroot is for root" >&2; exit 3; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

bare=${3:-$work/bare.tar}
if [ ! -e "$bare" ]; then
    mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' | head -n 1)
    mmdebstrap --mode=root --variant=minbase "$suite" "$bare" "$mirror"
fi
root=$work/root
mkdir "$root"
tar -C "$root" --numeric-owner -xpf "$bare"
cp /etc/resolv.conf "$root/etc/resolv.conf"
mkdir "$root/hvi"
cp "$packages"/*.deb "$packages"/*.whl "$packages"/*.tar.gz "$here/smoke.sh" "$here/../README.md" "$root/hvi"
# NOTE: a namespace of its own, so that nothing stays mounted.
unshare --mount --pid --fork sh -euc \
    'mount -t proc proc "$1/proc"; exec chroot "$1" env -i HOME=/root LC_ALL=C.UTF-8 \
        PATH=/usr/sbin:/usr/bin:/sbin:/bin bash /hvi/smoke.sh' sh "$root"
echo "ok: $suite"
