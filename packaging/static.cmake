# Links hvi-gen with static libraries alone, so that it needs nothing but glibc of the Linux it runs on.
# The preset `static` has CMake read this after project(); packaging/static_libraries.sh makes the
# libraries that Debian has only as shared ones. All is compiled as for the preset `release`, with the
# same headers: ccache knows it already.
# SPDX-License-Identifier: GPL-2.0-or-later
#
# NOTE: glibc itself is not linked: what hvi-gen compiles is loaded by dlopen, as is HDF5's library, and
# a static glibc loads only what was built with the very same one.

find_library(HDF5_LIBRARY NAMES hdf5_serial hdf5)  # loaded where it is used, by its name alone
set(CMAKE_FIND_LIBRARY_SUFFIXES .a)

# What find_package would take the shared libraries for. NOTE: both targets of fmt, or its own file
# refuses to be read; and the definitions that Debian's files give.
set(libraries "${HVI_STATIC_LIBRARIES}/lib")
set(ARB_LIBRARY "${libraries}/libarb.a")
set(FLINT_LIBRARY "${libraries}/libflint.a")
add_library(fmt::fmt-header-only INTERFACE IMPORTED GLOBAL)
foreach(name IN ITEMS fmt tomlplusplus)
    add_library(${name}::${name} STATIC IMPORTED GLOBAL)
    set_target_properties(${name}::${name} PROPERTIES IMPORTED_LOCATION "${libraries}/lib${name}.a")
endforeach()
target_compile_definitions(fmt::fmt INTERFACE FMT_SHARED)
target_compile_options(tomlplusplus::tomlplusplus INTERFACE -DTOML_HEADER_ONLY=0 -DTOML_SHARED_LIB=1)

# Last, what those need in their turn. NOTE: -lgmp would take the shared library.
set(CMAKE_CXX_STANDARD_LIBRARIES "-l:libcln.a -l:libmpfr.a -l:libgmp.a")
# What nothing calls is left out, since parts of the library of C++ would want a newer glibc.
string(APPEND CMAKE_EXE_LINKER_FLAGS " -static-libstdc++ -static-libgcc -Wl,--gc-sections")
