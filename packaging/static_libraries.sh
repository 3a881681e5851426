#!/usr/bin/env bash
# Builds FLINT, Arb and fmt from the sources of this Debian as static libraries, and toml++ from its
# headers: of these it has none. GiNaC, CLN, GMP and MPFR come with theirs; the others are headers.
# SPDX-License-Identifier: GPL-2.0-or-later
#
# usage: static_libraries.sh DIRECTORY    # the libraries are in DIRECTORY/lib
set -euo pipefail

mkdir -p "$1"
prefix=$(cd "$1" && pwd -P)
sources=(flint flint-arb fmtlib)
jobs=$(nproc)

# Sources are looked for where packages come from, in lists of our own: nothing of the system changes.
fetch() {
    mkdir -p "$prefix/apt/lists/partial" "$prefix/source"
    apt-get indextargets --format \
        'deb-src $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
        sort -u > "$prefix/apt/sources.list"
    local apt=(apt-get -o "Dir::Etc::sourcelist=$prefix/apt/sources.list"
        -o Dir::Etc::sourceparts=/dev/null -o "Dir::State::lists=$prefix/apt/lists"
        -o APT::Sandbox::User=root)
    "${apt[@]}" update
    (cd "$prefix/source" && "${apt[@]}" source --only-source "${sources[@]}")
}

# in_source NAME COMMAND...: runs it in the directory of that source.
in_source() {
    local directory
    directory=$(cd "$prefix/source" && find . -maxdepth 1 -type d -name "$1-[0-9]*" | head -n 1)
    (cd "$prefix/source/$directory" && "${@:2}")
}

# built_by_make CONFIGURE-OPTION...
# NOTE: their configure scripts know neither DESTDIR nor a separate build directory; without -g they
# are a tenth of the size.
built_by_make() {
    ./configure --prefix="$prefix" --disable-shared CFLAGS="-O2 -fPIC -std=gnu11" "$@"
    make -j "$jobs" library
    make install
}

built_by_cmake() {
    cmake -S . -B build -D CMAKE_BUILD_TYPE=Release -D BUILD_SHARED_LIBS=OFF \
        -D "CMAKE_INSTALL_PREFIX=$prefix" -D CMAKE_INSTALL_LIBDIR=lib "$@"
    cmake --build build -j "$jobs"
    cmake --install build
}

built_of_headers() {
    printf '#define TOML_IMPLEMENTATION\n#include <toml++/toml.h>\n' > "$prefix/source/toml.cpp"
    g++ -std=c++17 -O2 -D TOML_HEADER_ONLY=0 -c "$prefix/source/toml.cpp" -o "$prefix/source/toml.o"
    ar rcs "$prefix/lib/libtomlplusplus.a" "$prefix/source/toml.o"
}

fetch
in_source fmtlib built_by_cmake -D FMT_TEST=OFF -D FMT_DOC=OFF
built_of_headers
in_source flint built_by_make
in_source flint-arb built_by_make --with-flint="$prefix"
