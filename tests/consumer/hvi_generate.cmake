# Installs hvi with its generator, as it is built in BUILD, and has it write the steppers of a project.
# SPDX-License-Identifier: GPL-2.0-or-later

include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")

run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/installed")
build_and_run("${CMAKE_CURRENT_LIST_DIR}/generate" generate -D "CMAKE_PREFIX_PATH=${WORK}/installed")
