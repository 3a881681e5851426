# Two rooms know GiNaC and CLN: generator/exact and generator/hamiltonian.
# SPDX-License-Identifier: GPL-2.0-or-later

file(GLOB_RECURSE files RELATIVE "${ROOT}"
    "${ROOT}/generator/*.[ch]pp" "${ROOT}/src/*.hpp" "${ROOT}/generated/*.hpp" "${ROOT}/templates/*")
list(FILTER files EXCLUDE REGEX "^generator/(exact|hamiltonian)/")
set(leaks)
foreach(file IN LISTS files)
    file(STRINGS "${ROOT}/${file}" lines REGEX "#[ \t]*include[ \t]*[<\"](ginac|cln)/")
    if(lines)
        string(APPEND leaks "\n  ${file}: ${lines}")
    endif()
endforeach()
if(leaks)
    message(FATAL_ERROR "GiNaC or CLN is included outside its rooms:${leaks}")
endif()
