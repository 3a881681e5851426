# Random123::header, the headers of counter-based random numbers (Debian: librandom123-dev).
# SPDX-License-Identifier: GPL-2.0-or-later

find_path(RANDOM123_INCLUDE_DIR Random123/philox.h)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Random123 REQUIRED_VARS RANDOM123_INCLUDE_DIR)

if(Random123_FOUND AND NOT TARGET Random123::header)
    add_library(Random123::header INTERFACE IMPORTED)
    target_include_directories(Random123::header INTERFACE "${RANDOM123_INCLUDE_DIR}")
endif()
mark_as_advanced(RANDOM123_INCLUDE_DIR)
