# A switch for changes that keep the bytes of generated steppers. With -D KEEP=ON it writes to LIST a
# digest of each header in WRITTEN, which hvi-gen has written for the tests; without, it says which
# are not what they were. Which files of the runtime a header includes, of which format, and which
# version wrote it, does not count.
#
#     cmake --build build/dev --target keep-digests      before the change
#     cmake --build build/dev --target compare-digests   after it
#
# SPDX-License-Identifier: GPL-2.0-or-later

file(GLOB_RECURSE headers LIST_DIRECTORIES OFF RELATIVE "${WRITTEN}" "${WRITTEN}/*.hpp")
list(SORT headers)
set(current)
foreach(header IN LISTS headers)
    file(READ "${WRITTEN}/${header}" text)
    string(REGEX REPLACE "\n#include [^\n]*" "" text "${text}")
    string(REGEX REPLACE "supports_format.[0-9]+." "" text "${text}")
    string(REGEX REPLACE "^// Written by hvi-gen [^\n]*\n" "" text "${text}")
    string(SHA256 digest "${text}")
    string(REGEX MATCH "/(.*)" name "${header}")
    list(APPEND current "${digest}  ${CMAKE_MATCH_1}")
endforeach()
if(KEEP)
    list(JOIN current "\n" text)
    file(WRITE "${LIST}" "${text}\n")
    return()
endif()

file(STRINGS "${LIST}" expected)
set(gone ${expected})
list(REMOVE_ITEM gone ${current})
list(REMOVE_ITEM current ${expected})
if(gone OR current)
    list(TRANSFORM gone PREPEND "\n  - ")
    list(TRANSFORM current PREPEND "\n  + ")
    list(JOIN gone "" gone)
    list(JOIN current "" current)
    message(FATAL_ERROR "steppers are not what they were:${gone}${current}")
endif()
