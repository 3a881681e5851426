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

    # hvi_install_help(directory file word...): what hvi-gen says of itself, for shells and man.
    # NOTE: written when the program is built, so that nobody runs it while installing.
    function(hvi_install_help directory file)
        set(program hvi-gen)
        if(HVI_GEN_EXECUTABLE)
            set(program "${HVI_GEN_EXECUTABLE}")
        endif()
        set(written "${PROJECT_BINARY_DIR}/help/${directory}/${file}")
        cmake_path(GET written PARENT_PATH parent)
        file(MAKE_DIRECTORY "${parent}")
        add_custom_command(OUTPUT "${written}"
            COMMAND "${program}" ${ARGN} -o "${written}"
            DEPENDS "${program}"
            VERBATIM)
        set_property(GLOBAL APPEND PROPERTY hvi_help_files "${written}")
        install(FILES "${written}" DESTINATION "${CMAKE_INSTALL_DATADIR}/${directory}")
    endfunction()
    hvi_install_help(bash-completion/completions hvi-gen completions bash)
    hvi_install_help(zsh/site-functions _hvi-gen completions zsh)
    hvi_install_help(fish/vendor_completions.d hvi-gen.fish completions fish)
    hvi_install_help(man/man1 hvi-gen.1 manual)
    get_property(help_files GLOBAL PROPERTY hvi_help_files)
    add_custom_target(hvi_help ALL DEPENDS ${help_files})
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
