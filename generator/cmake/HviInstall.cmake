# What `cmake --install` puts where, and what find_package(hvi) and pkg-config read. Each part is a
# component, of which packaging/packages.cmake makes a package: `program`, `headers` and `python`.
# SPDX-License-Identifier: GPL-2.0-or-later

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# NOTE: under share/, as nothing there depends on the machine; and no path in it is absolute, so that
# the whole may be moved.
set(hvi_package_dir "${CMAKE_INSTALL_DATADIR}/cmake/hvi")

set_target_properties(hvi_runtime PROPERTIES EXPORT_NAME runtime)
set_target_properties(hvi_generated PROPERTIES EXPORT_NAME generated)
install(TARGETS hvi_runtime hvi_generated EXPORT hvi-targets FILE_SET HEADERS COMPONENT headers)
install(EXPORT hvi-targets NAMESPACE hvi:: DESTINATION "${hvi_package_dir}" COMPONENT headers)
# NOTE: a file of its own, as the headers may be installed without the program.
if(HVI_BUILD_GENERATOR)
    install(TARGETS hvi-gen EXPORT hvi-gen-targets RUNTIME COMPONENT program)
    install(EXPORT hvi-gen-targets NAMESPACE hvi:: DESTINATION "${hvi_package_dir}" COMPONENT program)
endif()

configure_package_config_file(
    generator/cmake/hvi-config.cmake.in "${PROJECT_BINARY_DIR}/hvi-config.cmake"
    INSTALL_DESTINATION "${hvi_package_dir}")
# NOTE: any architecture: what a user compiles against is headers.
write_basic_package_version_file(
    "${PROJECT_BINARY_DIR}/hvi-config-version.cmake"
    COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES
    "${PROJECT_BINARY_DIR}/hvi-config.cmake"
    "${PROJECT_BINARY_DIR}/hvi-config-version.cmake"
    generator/cmake/HviGenerate.cmake
    DESTINATION "${hvi_package_dir}" COMPONENT headers)
configure_file(generator/cmake/hvi.pc.in "${PROJECT_BINARY_DIR}/hvi.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/hvi.pc" DESTINATION "${CMAKE_INSTALL_DATADIR}/pkgconfig" COMPONENT headers)

install(FILES LICENSE LICENSES/MIT.txt LICENSES/GPL-2.0-or-later.txt
    DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT licences)

# Where things are; last, so that it stands at the end of the output.
configure_file(generator/cmake/say_what_is_where.cmake.in
    "${PROJECT_BINARY_DIR}/say_what_is_where.cmake" @ONLY)
install(SCRIPT "${PROJECT_BINARY_DIR}/say_what_is_where.cmake" COMPONENT guide)
