# Packages of Debian, by `cpack` in a build directory: hvi-gen, libhvi-dev and python3-hvi. Also the
# target `wheel`, the package for Python with this build's hvi-gen inside.
# SPDX-License-Identifier: GPL-2.0-or-later

set(packaging "${PROJECT_SOURCE_DIR}/packaging")

# ---- the licences of what hvi-gen is linked with for good ----

set(linked)
if(HVI_BUILD_GENERATOR AND HVI_STATIC_LIBRARIES)
    set(linked "${PROJECT_BINARY_DIR}/linked-libraries.txt")
    set(text "hvi-gen (GPL-2.0-or-later) has these libraries in it. As MPFR is under LGPL-3.0-or-later, the program
as a whole is GPL-3.0-or-later. First what Debian says of each library, then the licences.
")
    file(GLOB library_of_cxx RELATIVE /usr/share/doc /usr/share/doc/libstdc++-*-dev)
    foreach(package IN ITEMS libginac-dev libcln-dev libgmp-dev libmpfr-dev libflint-dev libflint-arb-dev
            libfmt-dev libtomlplusplus-dev nlohmann-json3-dev libcli11-dev libeigen3-dev libboost-dev
            librandom123-dev
            ${library_of_cxx})
        file(READ "/usr/share/doc/${package}/copyright" said)
        string(APPEND text "\n======== ${package} ========\n\n${said}")
    endforeach()
    foreach(licence IN ITEMS GPL-3 LGPL-3 LGPL-2.1)
        file(READ "/usr/share/common-licenses/${licence}" said)
        string(APPEND text "\n======== ${licence} ========\n\n${said}")
    endforeach()
    file(WRITE "${linked}" "${text}")
    install(FILES "${linked}" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT licences)
    install(FILES "${linked}" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/hvi-gen"
        COMPONENT program EXCLUDE_FROM_ALL)
endif()

# ---- what only packages of Debian have: no `cmake --install` without a component puts it anywhere ----

# NOTE: the place in which Debian's python3 looks, whatever the libraries of this system are in.
install(DIRECTORY "${PROJECT_SOURCE_DIR}/python/hvi" DESTINATION lib/python3/dist-packages
    COMPONENT python EXCLUDE_FROM_ALL
    FILES_MATCHING PATTERN "*.py" PATTERN "py.typed" PATTERN "__pycache__" EXCLUDE PATTERN "bin" EXCLUDE)

# hvi_debian(component package architecture): its name, licence and changelog.
function(hvi_debian component package architecture)
    install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" RENAME copyright
        DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" COMPONENT ${component} EXCLUDE_FROM_ALL)
    install(FILES "${PROJECT_SOURCE_DIR}/LICENSES/MIT.txt" "${packaging}/changelog.md"
        DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" COMPONENT ${component} EXCLUDE_FROM_ALL)
    string(TOUPPER "${component}" COMPONENT)
    set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_NAME ${package} PARENT_SCOPE)
    set(CPACK_DEBIAN_${COMPONENT}_FILE_NAME "${package}_${PROJECT_VERSION}_${architecture}.deb" PARENT_SCOPE)
    set(CPACK_DEBIAN_${COMPONENT}_PACKAGE_ARCHITECTURE ${architecture} PARENT_SCOPE)
endfunction()

# ---- what cpack reads ----

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL headers python)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_VENDOR "the hvi authors")
set(CPACK_PACKAGE_CONTACT "the hvi authors <hvi@localhost>")  # NOTE: Debian wants an address
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)

if(HVI_BUILD_GENERATOR)
    list(PREPEND CPACK_COMPONENTS_ALL program)
    execute_process(COMMAND dpkg --print-architecture OUTPUT_VARIABLE architecture
        OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT architecture)
        set(architecture "${CMAKE_SYSTEM_PROCESSOR}")
    endif()
    hvi_debian(program hvi-gen ${architecture})
    set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "hvi-gen derives a symplectic method exactly, writes it as a C++ header for the
system that a file describes, and compiles and runs it. Without a compiler it
takes the same steps by itself.")
    set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
    set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "g++, gnuplot-nox")
    set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "libhvi-dev, python3-hvi, libhdf5-103-1")
endif()

hvi_debian(headers libhvi-dev all)
set(CPACK_COMPONENT_HEADERS_DESCRIPTION "What steppers that hvi-gen writes include, and ready-made ones. C++17; Newton's
method needs Eigen. find_package(hvi) and pkg-config find them.")
set(CPACK_DEBIAN_HEADERS_PACKAGE_RECOMMENDS "libeigen3-dev")
set(CPACK_DEBIAN_HEADERS_PACKAGE_SUGGESTS "hvi-gen, libxsimd-dev")
set(CPACK_DEBIAN_HEADERS_PACKAGE_SECTION libdevel)

hvi_debian(python python3-hvi all)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION "The package hvi for Python takes steps of methods that hvi-gen derives and
compiles, and returns arrays.")
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= 3.9), python3-numpy, hvi-gen (>= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS
    "python3-sympy, python3-matplotlib, python3-xarray, python3-pandas")
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA "${packaging}/debian/postinst;${packaging}/debian/prerm")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)

include(CPack)

# ---- the wheel ----

if(HVI_BUILD_GENERATOR)
    # NOTE: that of the system first: setuptools and wheel are packages of it.
    find_program(HVI_PYTHON3 python3 PATHS /usr/bin NO_DEFAULT_PATH)
    find_program(HVI_PYTHON3 python3)
    mark_as_advanced(HVI_PYTHON3)
    add_custom_target(wheel
        COMMAND "${HVI_PYTHON3}" "${packaging}/make_wheel.py" "${PROJECT_SOURCE_DIR}" "$<TARGET_FILE:hvi-gen>"
            "${PROJECT_BINARY_DIR}/wheel" ${linked}
        DEPENDS hvi-gen
        COMMENT "Making the wheel"
        VERBATIM)
endif()
