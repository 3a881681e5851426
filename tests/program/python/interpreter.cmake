# HVI_PYTHON: a Python 3 that has numpy and sympy, or a false value. NOTE: the first on PATH may be one
# that somebody built, to which no package of the system belongs.
# SPDX-License-Identifier: GPL-2.0-or-later

set(HVI_PYTHON OFF)
foreach(directory IN ITEMS "" /usr/bin)
    unset(candidate)
    if(directory)
        find_program(candidate python3 PATHS ${directory} NO_DEFAULT_PATH NO_CACHE)
    else()
        find_program(candidate python3 NO_CACHE)
    endif()
    if(candidate)
        execute_process(COMMAND "${candidate}" -c "import numpy, sympy" RESULT_VARIABLE status
            OUTPUT_QUIET ERROR_QUIET)
        if(status EQUAL 0)
            set(HVI_PYTHON "${candidate}")
            return()
        endif()
    endif()
endforeach()
message(STATUS "no Python with numpy and sympy: its package is not tested")
