# Hdf5::header, the header of HDF5's C library (Debian: libhdf5-dev), and as HVI_HDF5_LIBRARY the name
# by which that is loaded where it is used: no program is linked with it.
# SPDX-License-Identifier: GPL-2.0-or-later

find_path(HDF5_INCLUDE_DIR hdf5.h PATH_SUFFIXES hdf5/serial)
find_library(HDF5_LIBRARY NAMES hdf5_serial hdf5)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Hdf5Header REQUIRED_VARS HDF5_LIBRARY HDF5_INCLUDE_DIR)

if(Hdf5Header_FOUND AND NOT TARGET Hdf5::header)
    # NOTE: libhdf5_serial.so.103 of libhdf5_serial.so.103.3.1, as the first number is that of the interface.
    file(REAL_PATH "${HDF5_LIBRARY}" library)
    cmake_path(GET library FILENAME library)
    string(REGEX REPLACE "(\\.so\\.[0-9]+).*" "\\1" library "${library}")
    add_library(Hdf5::header INTERFACE IMPORTED)
    target_include_directories(Hdf5::header INTERFACE "${HDF5_INCLUDE_DIR}")
    target_compile_definitions(Hdf5::header INTERFACE "HVI_HDF5_LIBRARY=\"${library}\"")
endif()
mark_as_advanced(HDF5_INCLUDE_DIR HDF5_LIBRARY)
