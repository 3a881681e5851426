# One room knows GiNaC and CLN, generator/hamiltonian: no file outside includes them, nor a header of
# the room through which it would reach them.
# SPDX-License-Identifier: GPL-2.0-or-later

cmake_minimum_required(VERSION 3.25)
set(room "generator/hamiltonian/")
set(reaches "[<\"](ginac|cln)/[^>\"]+[>\"]")
file(GLOB headers RELATIVE "${ROOT}" "${ROOT}/${room}*.hpp")
foreach(pass IN LISTS headers)  # as many times as a chain of includes may be long
    foreach(header IN LISTS headers)
        file(STRINGS "${ROOT}/${header}" lines REGEX "^#[ \t]*include[ \t]*(${reaches})")
        if(lines)
            string(APPEND reaches "|\"${header}\"")
            list(REMOVE_ITEM headers "${header}")
        endif()
    endforeach()
endforeach()

file(GLOB_RECURSE files RELATIVE "${ROOT}"
    "${ROOT}/generator/*.[ch]pp" "${ROOT}/src/*.hpp" "${ROOT}/generated/*.hpp" "${ROOT}/templates/*"
    "${ROOT}/tests/*.[ch]pp" "${ROOT}/bench/*.[ch]pp")
list(FILTER files EXCLUDE REGEX "^${room}")
set(leaks)
foreach(file IN LISTS files)
    file(STRINGS "${ROOT}/${file}" lines REGEX "#[ \t]*include[ \t]*(${reaches})")
    if(lines)
        string(APPEND leaks "\n  ${file}: ${lines}")
    endif()
endforeach()
if(leaks)
    message(FATAL_ERROR "GiNaC or CLN is included outside its room:${leaks}")
endif()
