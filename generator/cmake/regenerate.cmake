# Writes the headers that LIST names into the directory OUTPUT, with the program HVI_GEN.
# SPDX-License-Identifier: GPL-2.0-or-later

file(STRINGS "${LIST}" lines REGEX "^[^#]")
set(headers)
foreach(line IN LISTS lines)
    separate_arguments(words UNIX_COMMAND "${line}")
    list(POP_FRONT words name)
    list(APPEND headers "${name}.hpp")
    execute_process(
        COMMAND "${HVI_GEN}" stepper ${words} -o "${OUTPUT}/${name}.hpp"
        COMMAND_ERROR_IS_FATAL ANY)
endforeach()

# What is in the directory and not in the list is of yesterday.
file(GLOB present RELATIVE "${OUTPUT}" "${OUTPUT}/*")
list(REMOVE_ITEM present ${headers})
foreach(file IN LISTS present)
    file(REMOVE "${OUTPUT}/${file}")
endforeach()
