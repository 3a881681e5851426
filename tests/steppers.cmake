# hvi_steppers(target table): the steppers of a table, in the INTERFACE library `target`. A line of the
# table has a header without its ending, the name of its class, and the other arguments of
# `hvi-gen stepper` as in a shell. Files of scenes are relative to tests/.
# SPDX-License-Identifier: GPL-2.0-or-later

function(hvi_steppers target table)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${table}")
    file(STRINGS "${table}" lines REGEX "^[^#]")
    foreach(line IN LISTS lines)
        separate_arguments(words UNIX_COMMAND "${line}")
        list(POP_FRONT words header class)
        set(scene ${words})
        list(FILTER scene INCLUDE REGEX "[.]toml$")
        list(FILTER words EXCLUDE REGEX "[.]toml$")
        hvi_generate(TARGET ${target} HEADER ${header}.hpp NAME ${class} SCENE ${scene}
            OPTIONS ${words})
    endforeach()
endfunction()
