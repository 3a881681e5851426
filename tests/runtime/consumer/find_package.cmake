# Installs hvi without its generator, moves it elsewhere, and builds examples/find_package with it.
# SPDX-License-Identifier: GPL-2.0-or-later

include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")

run("${CMAKE_COMMAND}" -S "${HVI}" -B "${WORK}/hvi" ${common}
    -D HVI_BUILD_GENERATOR=OFF -D HVI_BUILD_TESTS=OFF -D HVI_BUILD_EXAMPLES=OFF)
run("${CMAKE_COMMAND}" --install "${WORK}/hvi" --prefix "${WORK}/first place")
file(RENAME "${WORK}/first place" "${WORK}/installed")
build_and_run("${HVI}/examples/find_package" my_simulation -D "CMAKE_PREFIX_PATH=${WORK}/installed")
