# Where ccache is installed, what has been compiled once is not compiled again: not in this build
# directory, and not in another checkout with the same text.
# SPDX-License-Identifier: GPL-2.0-or-later

find_program(HVI_CCACHE ccache DOC "The compiler's cache; empty for none")
mark_as_advanced(HVI_CCACHE)
if(NOT HVI_CCACHE OR CMAKE_CXX_COMPILER_LAUNCHER)
    return()
endif()

# Paths below the checkout are relative to it, and precompiled headers count by what they hold.
set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND}" -E env
    "CCACHE_BASEDIR=${PROJECT_SOURCE_DIR}" CCACHE_NOHASHDIR=1
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
    sh "${CMAKE_CURRENT_LIST_DIR}/cached.sh" "${HVI_CCACHE}")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fpch-preprocess)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    # NOTE: CMake hands clang its paths by -Xclang, where ccache does not see that they are paths.
    set(CMAKE_CXX_COMPILE_OPTIONS_CREATE_PCH
        -Xclang -emit-pch -Xclang -fno-pch-timestamp -include <PCH_HEADER> -x c++-header)
    set(CMAKE_CXX_COMPILE_OPTIONS_USE_PCH -Xclang -fno-pch-timestamp -include-pch <PCH_FILE>)
endif()
