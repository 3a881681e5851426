# Runs kernels as their text for a card has them: DEVICE_COMPILER with DEVICE_OPTIONS writes the text, which
# PYTHON translates to C; COMPILER with OPTIONS compiles that, and run_text.cpp, which compares bits. OUTPUT is
# where the files begin that this writes.
# SPDX-License-Identifier: GPL-2.0-or-later
cmake_minimum_required(VERSION 3.25)

set(here "${CMAKE_CURRENT_LIST_DIR}")
function(run)
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
run("${DEVICE_COMPILER}" ${DEVICE_OPTIONS} "${here}/kernels_to_run.cu" -o "${OUTPUT}.ptx")
run("${PYTHON}" -B "${here}/text_to_c.py" "${OUTPUT}.ptx" OUTPUT_FILE "${OUTPUT}.c")
run("${COMPILER}" -x c -O0 -w -c "${OUTPUT}.c" -o "${OUTPUT}.o")
run("${COMPILER}" ${OPTIONS} -O1 -x c++ "${here}/run_text.cpp" -x none "${OUTPUT}.o" -lm -o "${OUTPUT}_run")
run("${OUTPUT}_run")
