# Writes OUTPUT, the example in the docstrings of the header FILE, src/hvi/NAME.hpp: what follows
# its #include lines is in the namespace example_of_NAME, so that examples are one program. A
# compiler that finds a fault in it names the line of the header.
# SPDX-License-Identifier: GPL-2.0-or-later
#
# An example is a whole program under the heading `# Use`, and says whether what it shows is so:
#
#     /// # Use
#     /// What one has to know.
#     /// ```cpp
#     /// #include <...>
#     ///
#     /// int main() {
#     ///     ...
#     ///     return condition ? 0 : 1;
#     /// }
#     /// ```

cmake_minimum_required(VERSION 3.25)

set(fence "\n/// ```")
set(header "src/hvi/${NAME}.hpp")

function(line_of position result)  # the first line of `text` is 1
    string(SUBSTRING "${text}" 0 ${position} before)
    string(REGEX REPLACE "[^\n]" "" before "${before}")
    string(LENGTH "${before}" lines)
    math(EXPR line "${lines} + 1")
    set(${result} ${line} PARENT_SCOPE)
endfunction()

# NOTE: a list would lose the brackets and semicolons of C++, so the text stays one string.
file(READ "${FILE}" text)
string(REGEX MATCHALL "\n/// # Use\n" headings "${text}")
list(LENGTH headings count)
if(NOT count EQUAL 1)
    message(FATAL_ERROR "${header}: its docstrings have ${count} lines `# Use`, in place of one")
endif()
string(FIND "${text}" "${fence}cpp\n" begin)
string(FIND "${text}" "${fence}cpp\n" last REVERSE)
if(begin EQUAL -1 OR NOT begin EQUAL last)
    message(FATAL_ERROR "${header}: its docstrings have no example, or more than one")
endif()
string(LENGTH "${fence}cpp" length)
math(EXPR begin "${begin} + ${length}")
string(SUBSTRING "${text}" ${begin} -1 example)
string(FIND "${example}" "${fence}\n" end)
if(end EQUAL -1)
    message(FATAL_ERROR "${header}: the example in its docstring does not end")
endif()
string(SUBSTRING "${example}" 0 ${end} example)
string(REGEX MATCH "\n[^/][^\n]*|\n//[^/][^\n]*" stranger "${example}")
if(stranger)
    message(FATAL_ERROR "${header}: a line in its example is no docstring:${stranger}")
endif()
if(NOT example MATCHES "return [^;]+[?][^;]+: 1;[^;]*$")
    message(FATAL_ERROR "${header}: its example does not end by `return condition ? 0 : 1;`")
endif()

string(FIND "${example}" "\n/// #include" last_include REVERSE)
math(EXPR after "${last_include} + 1")
string(SUBSTRING "${example}" ${after} -1 rest)
string(FIND "${rest}" "\n" length)
math(EXPR after "${after} + ${length}")
string(SUBSTRING "${example}" 0 ${after} includes)
string(SUBSTRING "${example}" ${after} -1 program)
line_of(${begin} first_line)
math(EXPR position "${begin} + ${after}")
line_of(${position} program_line)
foreach(part IN ITEMS includes program)
    string(REGEX REPLACE "\n/// ?" "\n" ${part} "${${part}}")
endforeach()

file(WRITE "${OUTPUT}" "// Written by tests/runtime/docstrings/example.cmake. Do not edit.
#line ${first_line} \"${header}\"
${includes}
namespace example_of_${NAME} {
int main();
#line ${program_line} \"${header}\"
${program}
}  // namespace example_of_${NAME}
")
