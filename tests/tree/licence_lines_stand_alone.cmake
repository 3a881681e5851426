# The comment that a source file begins with has a line that names its licence and nothing else, so
# that tools find it; and where a template has such words, they are a line too.
# SPDX-License-Identifier: GPL-2.0-or-later
cmake_minimum_required(VERSION 3.25)

set(words "SPDX-License-Identifier: ")
set(licence "${words}(MIT|GPL-2.0-or-later)\n")

set(directories bench docs examples generated generator packaging src templates tests)
set(sources)
foreach(directory IN LISTS directories)
    file(GLOB_RECURSE files RELATIVE "${ROOT}"
        "${ROOT}/${directory}/*.[ch]pp" "${ROOT}/${directory}/*.cmake"
        "${ROOT}/${directory}/CMakeLists.txt" "${ROOT}/${directory}/*.sh"
        "${ROOT}/${directory}/*.gp" "${ROOT}/${directory}/*.def")
    list(APPEND sources ${files})
endforeach()
set(faults)
foreach(file IN LISTS sources ITEMS CMakeLists.txt dev)
    set(mark "#")
    if(file MATCHES "[.]([ch]pp|def)$")
        set(mark "//")
    endif()
    file(READ "${ROOT}/${file}" text)
    string(REGEX MATCH "^(${mark}[^\n]*\n)+" opening "${text}")
    if(NOT "\n${opening}" MATCHES "\n${mark} ${licence}")
        string(APPEND faults "\n  ${file}")
    endif()
endforeach()

# Parts of what hvi-gen writes: those that open a file say it.
file(GLOB templates RELATIVE "${ROOT}" "${ROOT}/templates/*")
foreach(file IN LISTS templates)
    file(STRINGS "${ROOT}/${file}" lines REGEX "${words}")
    list(FILTER lines EXCLUDE REGEX "^(//|#|[.]..) ${words}")
    if(lines)
        string(APPEND faults "\n  ${file}")
    endif()
endforeach()
if(faults)
    message(FATAL_ERROR "No line of its own says which licence these have:${faults}")
endif()
