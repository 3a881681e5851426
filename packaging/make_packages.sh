#!/usr/bin/env bash
# Makes packages of a build with static libraries: three of Debian, a wheel, and an archive.
# SPDX-License-Identifier: GPL-2.0-or-later
#
# usage: make_packages.sh BUILD DIRECTORY
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd -P)
build=$(cd "$1" && pwd -P)
mkdir -p "$2"
out=$(cd "$2" && pwd -P)

# The same sources make the same bytes: no clock and no habit of the user is in them.
release=$(sed -n 's/^## \([0-9.]*\) (\([0-9-]*\))$/\1 \2/p' "$here/changelog.md" | head -n 1)
version=${release% *}
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(date -u -d "${release#* }" +%s)}
umask 022

work=$(mktemp -d "$out/work.XXXXXX")
trap 'rm -rf "$work"' EXIT
rm -f "$out"/*.deb "$out"/*.whl "$out"/*.tar.gz "$out/SHA256SUMS"

(cd "$build" && cpack -B "$work/debian")
mv "$work"/debian/*.deb "$out"

cmake --build "$build" --target wheel
mv "$build"/wheel/*.whl "$out"

name=hvi-$version-linux-$(uname -m)
DESTDIR=$work/installed cmake --install "$build" --prefix "/$name" --strip
tar -C "$work/installed" --sort=name --owner=0 --group=0 --numeric-owner --mode=go-w \
    --mtime="@$SOURCE_DATE_EPOCH" -c "$name" | gzip -n -9 > "$out/$name.tar.gz"

cd "$out"
sha256sum -- *.deb *.whl *.tar.gz > SHA256SUMS
ls -l -- *.deb *.whl *.tar.gz
