# What both ways of using hvi have in common: run() a command, and build_and_run() a project.
# SPDX-License-Identifier: GPL-2.0-or-later

# NOTE: pkg-config finds nothing, as on a machine without GiNaC: nothing may ask for it.
set(ENV{PKG_CONFIG_LIBDIR} "${WORK}/nowhere")
set(common -G "${GENERATOR}" -D "CMAKE_CXX_COMPILER=${CXX}")

function(run)
    execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE failed)
    if(failed)
        message(FATAL_ERROR "${output}\nfailed: ${ARGN}")
    endif()
endfunction()

# build_and_run(source program option...)
function(build_and_run source program)
    run("${CMAKE_COMMAND}" -S "${source}" -B "${WORK}/build" ${common} ${ARGN})
    run("${CMAKE_COMMAND}" --build "${WORK}/build")
    run("${WORK}/build/${program}")
endfunction()

file(REMOVE_RECURSE "${WORK}")
