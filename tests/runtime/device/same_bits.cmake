# Both programs print the same.
# SPDX-License-Identifier: GPL-2.0-or-later
cmake_minimum_required(VERSION 3.25)

foreach(program IN ITEMS FIRST SECOND)
    execute_process(COMMAND "${${program}}" OUTPUT_VARIABLE ${program}_bits COMMAND_ERROR_IS_FATAL ANY)
endforeach()
string(LENGTH "${FIRST_bits}" length)
if(length LESS 1000)
    message(FATAL_ERROR "${FIRST} prints next to nothing")
endif()
if(NOT FIRST_bits STREQUAL SECOND_bits)
    message(FATAL_ERROR "the bits depend on how the compiler is called:\n${FIRST_bits}\n${SECOND_bits}")
endif()
