# Writes OUTPUT, the source of FUNCTION(), which returns the files of the list FILES.
# SPDX-License-Identifier: GPL-2.0-or-later
#
#   cmake -D OUTPUT=embedded.cpp -D HEADER=generator/emit/text/embedded.hpp -D FUNCTION=embedded_templates
#       -D "FILES=templates/a.hpp.in;src/hvi/b.hpp" -D ROOT=checkout -P embed.cmake
#
# A file is known by its path in src/, templates/, examples/scenes/ or python/hvi/. Raw string literals end where
# MSVC's limit of 16 kB ends; the pieces are put together by the compiler.

set(entries "")
foreach(file IN LISTS FILES)
    string(REGEX REPLACE "^(src|templates|examples/scenes|python/hvi)/" "" name "${file}")
    # NOTE: a list would lose the brackets and semicolons of C++, so the text stays one string.
    file(READ "${ROOT}/${file}" text)
    string(LENGTH "${text}" length)
    string(APPEND entries "        {\"${name}\",\n")
    set(begin 0)
    while(begin LESS length)
        string(SUBSTRING "${text}" ${begin} 8000 piece)
        string(APPEND entries "            R\"embedded(${piece})embedded\"\n")
        math(EXPR begin "${begin} + 8000")
    endwhile()
    # NOTE: the suffix tells the length, which compilers would else count within limits of their own.
    string(APPEND entries "            \"\"sv,\n        },\n")
endforeach()

file(WRITE "${OUTPUT}" "// Written by embed.cmake. Do not edit.
#include \"${HEADER}\"

#include <string_view>

namespace hvi::gen {

std::span<const EmbeddedFile> ${FUNCTION}() {
    using namespace std::string_view_literals;
    static constexpr EmbeddedFile files[] = {
${entries}    };
    return files;
}

}  // namespace hvi::gen
")
