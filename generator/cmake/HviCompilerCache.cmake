# Where ccache is installed, what has been compiled once is not compiled again: not in this build
# directory, and not in another checkout with the same text.
# SPDX-License-Identifier: GPL-2.0-or-later

find_program(HVI_CCACHE ccache DOC "The compiler's cache; empty for none")
mark_as_advanced(HVI_CCACHE)
if(NOT HVI_CCACHE OR CMAKE_CXX_COMPILER_LAUNCHER)
    return()
endif()

# Paths below the checkout are relative to it.
set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env
    "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_NOHASHDIR=1
    CCACHE_SLOPPINESS=time_macros,include_file_mtime,include_file_ctime "${HVI_CCACHE}")

# What is released has the same bytes as without the cache. NOTE: in other builds only the places that a
# broken invariant reports differ.
if(CMAKE_BUILD_TYPE STREQUAL "Release")
    file(RELATIVE_PATH hvi_to_sources "${PROJECT_BINARY_DIR}" "${PROJECT_SOURCE_DIR}")
    add_compile_options("-ffile-prefix-map=${hvi_to_sources}=")
endif()
