#!/usr/bin/env bash
# Tries the packages beside it on a bare Debian: try_in_chroot.sh calls it inside.
# SPDX-License-Identifier: GPL-2.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
export DEBIAN_FRONTEND=noninteractive
# NOTE: no pseudo-terminal, as a bare system has none.
apt_get() { apt-get -y -qq -o Dpkg::Use-Pty=0 "$@" > /dev/null; }
install() { apt_get install --no-install-recommends "$@"; }

say() { printf '\n== %s\n' "$*"; }

# run_kepler HVI-GEN [OPTION...]: each compiles for itself; no picture, as that needs gnuplot.
run_kepler() {
    XDG_CACHE_HOME=$(mktemp -d) "$1" run kepler --until 20 --only table,summary -o "$(mktemp -d)/out" "${@:2}" | grep ^energy
}

say "Packages of Debian, without a compiler"
apt_get update
install ./hvi-gen_*.deb ./libhvi-dev_*.deb ./python3-hvi_*.deb
hvi-gen --version
run_kepler hvi-gen --interpret

say "The archive, without a compiler"
tar -C /opt -xzf hvi-*.tar.gz
run_kepler /opt/hvi-*/bin/hvi-gen --interpret

say "With a compiler: runs, headers by pkg-config, Python"
install g++ pkg-config
run_kepler hvi-gen
run_kepler /opt/hvi-*/bin/hvi-gen
hvi-gen stepper --method gauss:4 kepler --energy -o kepler.hpp
sed -n '/^```cpp$/,/^```$/{/^```/d;p}' README.md > main.cpp
# shellcheck disable=SC2046 # several options
g++ -std=c++17 -O2 $(pkg-config --cflags hvi) main.cpp -o main
./main
PKG_CONFIG_PATH=$(echo /opt/hvi-*/share/pkgconfig) pkg-config --cflags hvi
cat > smoke.py <<'END_OF_PYTHON'
import hvi
result = hvi.Scene("kepler").integrate((0, 20), step=0.05, method="gauss:4")
assert result.success and abs(result.energy - result.energy[0]).max() < 1e-10
print("from", hvi.__file__, len(result.t), "rows")
END_OF_PYTHON
python3 smoke.py

say "All is removed again"
apt_get purge hvi-gen libhvi-dev python3-hvi
left=$(find /usr -path '*hvi*')
[ -z "$left" ] || { echo "error: left behind: $left" >&2; exit 1; }

say "The wheel"
install python3-venv python3-numpy
python3 -m venv --system-site-packages /opt/env
/opt/env/bin/pip install --quiet --no-index --no-deps ./hvi-*.whl
/opt/env/bin/python smoke.py
