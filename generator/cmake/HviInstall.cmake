# What `cmake --install` puts where, and what find_package(hvi) reads.
# SPDX-License-Identifier: GPL-2.0-or-later

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(hvi_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/hvi")

set_target_properties(hvi_runtime PROPERTIES EXPORT_NAME runtime)
set_target_properties(hvi_generated PROPERTIES EXPORT_NAME generated)
install(TARGETS hvi_runtime hvi_generated EXPORT hvi-targets FILE_SET HEADERS)
if(HVI_BUILD_GENERATOR)
    install(TARGETS hvi-gen EXPORT hvi-targets)
endif()
install(EXPORT hvi-targets NAMESPACE hvi:: DESTINATION "${hvi_package_dir}")

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
    DESTINATION "${hvi_package_dir}")
install(FILES LICENSE LICENSES/MIT.txt LICENSES/GPL-2.0-or-later.txt DESTINATION "${CMAKE_INSTALL_DOCDIR}")
