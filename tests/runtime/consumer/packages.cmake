# Makes the packages of Debian of what is built in BUILD, twice, with the same bytes; unpacks them, and
# uses each: hvi-gen writes the stepper of README.md's example, which pkg-config and CMake find headers
# for, and Python finds the package.
# SPDX-License-Identifier: GPL-2.0-or-later

include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")

# ---- the same bytes ----

set(ENV{SOURCE_DATE_EPOCH} 1000000000)
foreach(time IN ITEMS once again)
    # NOTE: gzip, as xz takes four times as long.
    execute_process(COMMAND "${CMAKE_CPACK_COMMAND}" -B "${WORK}/${time}" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip
        WORKING_DIRECTORY "${BUILD}"
        OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE failed)
    if(failed)
        message(FATAL_ERROR "${output}")
    endif()
endforeach()
file(GLOB packages "${WORK}/once/*.deb")
list(LENGTH packages count)
if(NOT count EQUAL 3)
    message(FATAL_ERROR "not three packages: ${packages}")
endif()
foreach(package IN LISTS packages)
    cmake_path(GET package FILENAME name)
    run("${CMAKE_COMMAND}" -E compare_files "${package}" "${WORK}/again/${name}")
endforeach()

# ---- what they need ----

# depends(package text): what the package depends on.
function(depends package text)
    file(GLOB file "${WORK}/once/${package}_*.deb")
    execute_process(COMMAND dpkg-deb -f "${file}" Depends OUTPUT_VARIABLE needed COMMAND_ERROR_IS_FATAL ANY)
    if(NOT needed MATCHES "${text}")
        message(FATAL_ERROR "${package} depends on ${needed}, not on ${text}")
    endif()
endfunction()
depends(hvi-gen "libc6 ")
depends(libhvi-dev "^\n?$")
depends(python3-hvi "python3-numpy, hvi-gen ")

# ---- what they have ----

foreach(package IN LISTS packages)
    run(dpkg-deb -x "${package}" "${WORK}/root")
endforeach()
set(usr "${WORK}/root/usr")
foreach(package IN ITEMS hvi-gen libhvi-dev python3-hvi)
    if(NOT EXISTS "${usr}/share/doc/${package}/copyright")
        message(FATAL_ERROR "${package} does not say which licence it has")
    endif()
endforeach()

run("${usr}/bin/hvi-gen" stepper --method gauss:4 kepler --energy -o "${WORK}/kepler.hpp")
file(READ "${HVI}/README.md" readme)
string(REGEX MATCH "```cpp\n(.*int main.*\n})\n```" code "${readme}")
file(WRITE "${WORK}/main.cpp" "${CMAKE_MATCH_1}\n")
set(ENV{PKG_CONFIG_PATH} "${usr}/share/pkgconfig")
execute_process(COMMAND pkg-config --cflags hvi OUTPUT_VARIABLE flags COMMAND_ERROR_IS_FATAL ANY)
separate_arguments(flags UNIX_COMMAND "${flags}")
run("${CXX}" -std=c++17 ${flags} "${WORK}/main.cpp" -o "${WORK}/main")
run("${WORK}/main")

build_and_run("${HVI}/tests/runtime/consumer/generate" generate -D "CMAKE_PREFIX_PATH=${usr}")

set(ENV{PYTHONPATH} "${usr}/lib/python3/dist-packages")
set(ENV{HVI_GEN} "${usr}/bin/hvi-gen")
run(python3 -B -c "import hvi; print(hvi.Scene('kepler'), hvi.tableau('gauss:2'))")
