# Compares the directory SHIPPED with what HVI_GEN writes today for LIST into the directory FRESH.
# SPDX-License-Identifier: GPL-2.0-or-later

file(REMOVE_RECURSE "${FRESH}")
file(MAKE_DIRECTORY "${FRESH}")
set(OUTPUT "${FRESH}")
include("${CMAKE_CURRENT_LIST_DIR}/../../generator/cmake/regenerate.cmake")

execute_process(COMMAND diff -ru "${SHIPPED}" "${FRESH}" RESULT_VARIABLE differ OUTPUT_VARIABLE difference)
if(differ)
    message("${difference}")
    message(FATAL_ERROR "generated/ is not what hvi-gen writes. If the change is meant: "
        "cmake --build build/release --target update-generated")
endif()
