# Headers take most of the time of the compiler: where files are united, those of a room are compiled
# some dozen at a time, as one unit that includes them.
# SPDX-License-Identifier: GPL-2.0-or-later

option(HVI_UNITE "Compile the files of a room together; else each is a unit of its own" OFF)

# hvi_unite(result prefix file...): what to compile in place of the files, which are given relative
# to the project. NOTE: CMake's own UNITY_BUILD names the files by absolute paths, which ccache does
# not find again in another checkout.
function(hvi_unite result prefix)
    if(NOT HVI_UNITE)
        list(TRANSFORM ARGN PREPEND "${PROJECT_SOURCE_DIR}/" OUTPUT_VARIABLE files)
        set(${result} ${files} PARENT_SCOPE)
        return()
    endif()
    set(most 12)
    list(LENGTH ARGN count)
    math(EXPR unit_count "(${count} + ${most} - 1) / ${most}")
    set(units)
    foreach(k RANGE 1 ${unit_count})
        math(EXPR begin "${count} * (${k} - 1) / ${unit_count}")
        math(EXPR size "${count} * ${k} / ${unit_count} - ${begin}")
        list(SUBLIST ARGN ${begin} ${size} files)
        list(TRANSFORM files REPLACE "(.+)" "#include \"\\1\"\n")
        list(JOIN files "" text)
        set(unit "${CMAKE_CURRENT_BINARY_DIR}/units/${prefix}_${k}.cpp")
        file(CONFIGURE OUTPUT "${unit}" CONTENT "${text}")
        list(APPEND units "${unit}")
    endforeach()
    set(${result} ${units} PARENT_SCOPE)
endfunction()
