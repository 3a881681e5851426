# The warnings that every target of hvi itself is compiled with. They become errors where a preset
# sets CMAKE_COMPILE_WARNING_AS_ERROR.
# SPDX-License-Identifier: GPL-2.0-or-later

function(hvi_warnings target)
    target_compile_options(${target} PRIVATE
        -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion
        # g++ 12 warns of these where there is nothing, deep in std::string.
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
        $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
endfunction()
