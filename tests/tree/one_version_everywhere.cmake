# The version of project(hvi VERSION ...) is that of the newest entry of the changelog, of CITATION.cff
# and of each recipe; and the day of the release is the same in the changelog and in CITATION.cff.
# SPDX-License-Identifier: GPL-2.0-or-later
cmake_minimum_required(VERSION 3.25)

set(faults)

# says(file pattern expected): the first group of the first match in the file.
function(says file pattern expected)
    file(READ "${ROOT}/${file}" text)
    string(REGEX MATCH "${pattern}" match "${text}")
    if(NOT "${CMAKE_MATCH_1}" STREQUAL "${expected}")
        set(faults "${faults}\n  ${file}: \"${CMAKE_MATCH_1}\", not ${expected}" PARENT_SCOPE)
    endif()
endfunction()

says(packaging/changelog.md "\n## ([^ \n]*)" "${VERSION}")
says(CITATION.cff "\nversion: ([^\n]*)" "${VERSION}")
says(packaging/conda/meta.yaml "\n  version: \"([^\"]*)\"" "${VERSION}")
says(packaging/spack/package.py "\n    version\\(\"([^\"]*)\"" "${VERSION}")
says(packaging/spack/package.py "hvi@([^\n]*)" "${VERSION}")
says(packaging/vcpkg/vcpkg.json "\"version\": \"([^\"]*)\"" "${VERSION}")

file(READ "${ROOT}/CITATION.cff" citation)
string(REGEX MATCH "\ndate-released: ([^\n]*)" match "${citation}")
says(packaging/changelog.md "\n## [^ \n]* \\(([^)]*)\\)" "${CMAKE_MATCH_1}")

if(faults)
    message(FATAL_ERROR "Versions differ:${faults}")
endif()
