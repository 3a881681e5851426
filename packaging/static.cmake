# Links hvi-gen with static libraries alone: with nothing but glibc, of whatever Linux it runs on. The
# preset `static` has CMake read this after project(); packaging/static_libraries.sh makes the libraries
# that Debian has only as shared ones.
# SPDX-License-Identifier: GPL-2.0-or-later
#
# NOTE: glibc itself is not linked: what hvi-gen compiles is loaded by dlopen, as is HDF5's library, and
# a static glibc loads only what was built with the very same one.

find_library(HDF5_LIBRARY NAMES hdf5_serial hdf5)  # loaded where it is used, by its name alone

set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
list(PREPEND CMAKE_PREFIX_PATH "${HVI_STATIC_LIBRARIES}")
find_library(ARB_LIBRARY NAMES arb PATHS "${HVI_STATIC_LIBRARIES}/lib" NO_DEFAULT_PATH REQUIRED)
find_library(FLINT_LIBRARY NAMES flint PATHS "${HVI_STATIC_LIBRARIES}/lib" NO_DEFAULT_PATH REQUIRED)
find_path(ARB_INCLUDE_DIR arb.h PATHS "${HVI_STATIC_LIBRARIES}/include" NO_DEFAULT_PATH REQUIRED)

# NOTE: Debian's target names the shared library.
find_path(tomlplusplus_INCLUDE toml++/toml.h REQUIRED)
add_library(tomlplusplus::tomlplusplus INTERFACE IMPORTED GLOBAL)
target_include_directories(tomlplusplus::tomlplusplus INTERFACE "${tomlplusplus_INCLUDE}")

# Last, what those need in their turn. NOTE: -lgmp would take the shared library.
set(CMAKE_CXX_STANDARD_LIBRARIES "-l:libcln.a -l:libmpfr.a -l:libgmp.a")
string(APPEND CMAKE_EXE_LINKER_FLAGS " -static-libstdc++ -static-libgcc")
