# Arb::arb, ball arithmetic with proven bounds: a library of its own (Debian calls it flint-arb), or
# a part of FLINT 3.
# SPDX-License-Identifier: GPL-2.0-or-later

find_path(ARB_INCLUDE_DIR arb.h PATH_SUFFIXES flint)
find_library(ARB_LIBRARY NAMES flint-arb arb flint)
find_library(FLINT_LIBRARY NAMES flint)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Arb REQUIRED_VARS ARB_LIBRARY FLINT_LIBRARY ARB_INCLUDE_DIR)

if(Arb_FOUND AND NOT TARGET Arb::arb)
    add_library(Arb::arb INTERFACE IMPORTED)
    target_include_directories(Arb::arb INTERFACE "${ARB_INCLUDE_DIR}")
    target_link_libraries(Arb::arb INTERFACE "${ARB_LIBRARY}" "${FLINT_LIBRARY}")
endif()
mark_as_advanced(ARB_INCLUDE_DIR ARB_LIBRARY FLINT_LIBRARY)
