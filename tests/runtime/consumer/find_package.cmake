# Installs hvi without its generator, moves it elsewhere, and builds examples/find_package with it, as
# CMake finds it there and as pkg-config does.
# SPDX-License-Identifier: GPL-2.0-or-later

include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")

run("${CMAKE_COMMAND}" -S "${HVI}" -B "${WORK}/hvi" ${common}
    -D HVI_BUILD_GENERATOR=OFF -D HVI_BUILD_TESTS=OFF -D HVI_BUILD_EXAMPLES=OFF)
run("${CMAKE_COMMAND}" --install "${WORK}/hvi" --prefix "${WORK}/first place")
file(RENAME "${WORK}/first place" "${WORK}/installed")
build_and_run("${HVI}/examples/find_package" my_simulation -D "CMAKE_PREFIX_PATH=${WORK}/installed")

set(ENV{PKG_CONFIG_PATH} "${WORK}/installed/share/pkgconfig")
execute_process(COMMAND pkg-config --cflags hvi OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
run("${CXX}" -std=c++17 ${flags} "${HVI}/examples/find_package/main.cpp" -o "${WORK}/by_pkg_config")
run("${WORK}/by_pkg_config")
