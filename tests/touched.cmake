# Runs the tests of BUILD that a change has touched: those of which something is not as it was when
# they last passed. What counts is what they are made of: the words of the command, the files among
# them, and the files and directories that the test says it needs (REQUIRED_FILES). A test by CMake
# that says nothing of that always runs.
# SPDX-License-Identifier: GPL-2.0-or-later
#
#   cmake -D BUILD=build/dev -P tests/touched.cmake

cmake_minimum_required(VERSION 3.25)

set(memory "${BUILD}/Testing/passed")

# The digest of a file, or of all files below a directory.
function(digest_of path result)
    set(files "${path}")
    if(IS_DIRECTORY "${path}")
        file(GLOB_RECURSE files "${path}/*")
    endif()
    set(digests)
    foreach(file IN LISTS files)
        file(SHA256 "${file}" digest)
        string(APPEND digests "${file} ${digest}\n")
    endforeach()
    string(SHA256 digest "${digests}")
    set(${result} "${digest}" PARENT_SCOPE)
endfunction()

# The items of the JSON array of `test` at the path; none where there is no such array.
function(items_of result test)
    set(items)
    string(JSON length ERROR_VARIABLE none LENGTH "${test}" ${ARGN})
    if(NOT none AND length GREATER 0)
        math(EXPR last "${length} - 1")
        foreach(i RANGE ${last})
            string(JSON item GET "${test}" ${ARGN} ${i})
            list(APPEND items "${item}")
        endforeach()
    endif()
    set(${result} "${items}" PARENT_SCOPE)
endfunction()

# What a test is made of; empty where it does not say.
function(ingredients_of test result)
    items_of(command "${test}" command)
    set(needed)
    items_of(properties "${test}" properties)
    foreach(property IN LISTS properties)
        string(JSON name GET "${property}" name)
        if(name STREQUAL "REQUIRED_FILES")
            items_of(needed "${property}" value)
        endif()
    endforeach()
    list(GET command 0 program)
    set(${result} "" PARENT_SCOPE)
    if(program STREQUAL CMAKE_COMMAND AND NOT needed)
        return()
    endif()
    string(SHA256 ingredients "${command}")
    list(FILTER command INCLUDE REGEX "^/")
    foreach(file IN LISTS command needed)
        if(file IN_LIST needed OR NOT IS_DIRECTORY "${file}")
            digest_of("${file}" digest)
            string(APPEND ingredients " ${digest}")
        endif()
    endforeach()
    string(SHA256 ingredients "${ingredients}")
    set(${result} "${ingredients}" PARENT_SCOPE)
endfunction()

execute_process(COMMAND "${CMAKE_CTEST_COMMAND}" --test-dir "${BUILD}" --show-only=json-v1
    OUTPUT_VARIABLE all COMMAND_ERROR_IS_FATAL ANY)
string(JSON count LENGTH "${all}" tests)
math(EXPR last "${count} - 1")
set(touched)
foreach(i RANGE ${last})
    string(JSON test GET "${all}" tests ${i})
    string(JSON name GET "${test}" name)
    ingredients_of("${test}" ingredients)
    set(before)
    if(EXISTS "${memory}/${name}")
        file(READ "${memory}/${name}" before)
    endif()
    if(NOT ingredients OR NOT ingredients STREQUAL before)
        list(APPEND touched "${name}")
        set(ingredients_${name} "${ingredients}")
    endif()
endforeach()

list(LENGTH touched number)
message("${number} of ${count} tests are touched by what has changed since they last passed")
list(JOIN touched "|" names)
execute_process(
    COMMAND "${CMAKE_CTEST_COMMAND}" --test-dir "${BUILD}" --output-on-failure --parallel 2
        --no-tests=ignore --tests-regex "^(${names})$"
    RESULT_VARIABLE result)
set(failed)
if(EXISTS "${BUILD}/Testing/Temporary/LastTestsFailed.log" AND NOT result EQUAL 0)
    file(STRINGS "${BUILD}/Testing/Temporary/LastTestsFailed.log" failed)
    list(TRANSFORM failed REPLACE "^[0-9]+:" "")
endif()
foreach(name IN LISTS touched)
    if(NOT name IN_LIST failed AND (result EQUAL 0 OR failed))
        file(WRITE "${memory}/${name}" "${ingredients_${name}}")
    endif()
endforeach()
if(NOT result EQUAL 0)
    message(FATAL_ERROR "a test failed")
endif()
