# Each file and directory of the checkout that README.md or a page of docs/ names is there, be it
# named by a path from the root, from generator/ or from src/hvi/, by a link, or by its last part
# alone, which is looked for in all of generator/ and src/.
# SPDX-License-Identifier: GPL-2.0-or-later
cmake_minimum_required(VERSION 3.25)

# What programs write, where a user says.
set(of_users hvi-gen/ report/)

# A word of several parts, or with an ending that only files of the checkout have.
set(several "([a-z_][A-Za-z0-9_-]+/)+[A-Za-z0-9_.*-]*")
set(file "[a-z0-9_*]+[.]([ch]pp|cmake|def|in|[*])")

function(is_there path result)
    string(REGEX REPLACE "/$" "" path "${path}")
    set(places "${path}" "generator/${path}" "src/hvi/${path}")
    if(path MATCHES "^hvi/")
        set(places "src/${path}" "generated/${path}")
    endif()
    list(TRANSFORM places PREPEND "${ROOT}/")
    file(GLOB found ${places})
    if(NOT found AND NOT path MATCHES "/")
        file(GLOB_RECURSE found "${ROOT}/generator/${path}" "${ROOT}/src/${path}")
    endif()
    set(${result} "${found}" PARENT_SCOPE)
endfunction()

file(GLOB pages RELATIVE "${ROOT}" "${ROOT}/README.md" "${ROOT}/docs/*.md" "${ROOT}/docs/inside/*.md")
set(missing)
foreach(page IN LISTS pages)
    file(READ "${ROOT}/${page}" text)
    string(REGEX MATCHALL "`(${several}|${file})`" words "${text}")
    string(REGEX MATCHALL "<hvi/[a-z0-9_/]+[.]hpp>" headers "${text}")
    list(APPEND words ${headers})
    list(TRANSFORM words REPLACE "[`<>]" "")
    list(REMOVE_DUPLICATES words)
    list(REMOVE_ITEM words ${of_users})
    foreach(word IN LISTS words)
        is_there("${word}" found)
        if(NOT found)
            string(APPEND missing "\n  ${page}: ${word}")
        endif()
    endforeach()

    cmake_path(GET page PARENT_PATH directory)
    string(REGEX MATCHALL "\\([A-Za-z0-9_./-]+[.](md|png|svg)(#[a-z0-9-]*)?\\)" links "${text}")
    list(TRANSFORM links REPLACE "[()]|#.*" "")
    foreach(link IN LISTS links)
        if(NOT EXISTS "${ROOT}/${directory}/${link}")
            string(APPEND missing "\n  ${page}: the link to ${link}")
        endif()
    endforeach()
endforeach()
if(missing)
    message(FATAL_ERROR "There are no such files:${missing}")
endif()
