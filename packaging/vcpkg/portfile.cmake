# hvi for vcpkg, from a checkout: an overlay port,
#     vcpkg install hvi --overlay-ports=CHECKOUT/packaging/vcpkg
# SPDX-License-Identifier: GPL-2.0-or-later

cmake_path(SET SOURCE_PATH NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../..")

vcpkg_check_features(OUT_FEATURE_OPTIONS features FEATURES generator HVI_BUILD_GENERATOR)
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}"
    OPTIONS ${features} -DHVI_BUILD_TESTS=OFF -DHVI_BUILD_EXAMPLES=OFF -DHVI_UNITE=ON)
vcpkg_cmake_install()
if("generator" IN_LIST FEATURES)
    vcpkg_copy_tools(TOOL_NAMES hvi-gen AUTO_CLEAN)
endif()
vcpkg_cmake_config_fixup(PACKAGE_NAME hvi CONFIG_PATH share/cmake/hvi)
vcpkg_fixup_pkgconfig()

file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE" "${SOURCE_PATH}/LICENSES/MIT.txt"
    "${SOURCE_PATH}/LICENSES/GPL-2.0-or-later.txt")
