# Builds a project that has hvi by FetchContent, with the main program of examples/find_package.
# SPDX-License-Identifier: GPL-2.0-or-later

include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")

file(WRITE "${WORK}/source/CMakeLists.txt" "
cmake_minimum_required(VERSION 3.25)
project(my_simulation LANGUAGES CXX)
include(FetchContent)
FetchContent_Declare(hvi SOURCE_DIR \"${HVI}\")
FetchContent_MakeAvailable(hvi)
add_executable(my_simulation \"${HVI}/examples/find_package/main.cpp\")
target_link_libraries(my_simulation PRIVATE hvi::generated)
")
build_and_run("${WORK}/source" my_simulation)
