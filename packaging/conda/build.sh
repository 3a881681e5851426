#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
set -euo pipefail
cmake -S . -B conda-build -G Ninja -D CMAKE_BUILD_TYPE=Release -D HVI_UNITE=ON \
    -D HVI_BUILD_TESTS=OFF -D HVI_BUILD_EXAMPLES=OFF ${CMAKE_ARGS:-} -D "CMAKE_INSTALL_PREFIX=$PREFIX"
cmake --build conda-build
cmake --install conda-build
