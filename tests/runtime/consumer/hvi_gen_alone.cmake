# All that is installed with hvi-gen is written when that target alone is built, as ./dev demo does.
# SPDX-License-Identifier: GPL-2.0-or-later

file(GLOB scripts "${BUILD}/cmake_install.cmake" "${BUILD}/generator/cmake_install.cmake")
set(installed)
foreach(script IN LISTS scripts)
    file(STRINGS "${script}" lines REGEX "/help/")
    string(REGEX MATCHALL "\"[^\"]*/help/[^\"]*\"" files "${lines}")
    list(APPEND installed ${files})
endforeach()
list(TRANSFORM installed REPLACE "\"" "")
list(LENGTH installed count)
if(NOT count EQUAL 4)
    message(FATAL_ERROR "not three completions and a man page: ${installed}")
endif()

execute_process(COMMAND "${NINJA}" -C "${BUILD}" -t commands hvi-gen
    OUTPUT_VARIABLE commands COMMAND_ERROR_IS_FATAL ANY)
foreach(file IN LISTS installed)
    string(FIND "${commands}" "${file}" place)
    if(place EQUAL -1)
        message(FATAL_ERROR "hvi-gen is built without ${file}, which is installed with it")
    endif()
endforeach()
