# Compiles FILES by COMPILER with OPTIONS to the program OUTPUT, and runs it.
# SPDX-License-Identifier: GPL-2.0-or-later
cmake_minimum_required(VERSION 3.25)

execute_process(COMMAND "${COMPILER}" ${OPTIONS} ${FILES} -o "${OUTPUT}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${OUTPUT}" COMMAND_ERROR_IS_FATAL ANY)
