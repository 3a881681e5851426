# No two files define types of one name in one namespace: classes would break the one-definition
# rule where a program links both, and aliases would mislead.
# SPDX-License-Identifier: GPL-2.0-or-later
cmake_minimum_required(VERSION 3.25)

# NOTE: clang-format puts what stands in a namespace at the start of its line, and the name of the
# namespace behind the brace that ends it.
set(template "(template <.*> )?")
set(attributes "(\\[\\[.*\\]\\] |alignas\\([^)]*\\) )*")
set(class "^${template}(class|struct|union|enum class|enum) ${attributes}([A-Za-z_0-9]+)(.*)$")
set(alias "^${template}(using) ()([A-Za-z_0-9]+) =")
# A class within a class, a specialisation, a forward declaration.
set(no_definition "^(::|<)|^( : [a-z_:0-9]+)?;")

file(GLOB_RECURSE files RELATIVE "${ROOT}" "${ROOT}/generator/*.[ch]pp" "${ROOT}/src/*.[ch]pp")
set(doubles)
foreach(file IN LISTS files)
    file(STRINGS "${ROOT}/${file}" lines REGEX
        "^(template <|class|struct|union|enum|using|namespace .*{$|}.*// namespace)")
    set(scopes)  # namespaces around a line, the innermost last; of those without a name only a dot
    foreach(line IN LISTS lines)
        if(line MATCHES "^namespace (.*){$")
            string(STRIP "${CMAKE_MATCH_1}" scope)
            list(APPEND scopes "${scope}.")
        elseif(line MATCHES "^}")
            list(POP_BACK scopes)
        elseif(NOT "." IN_LIST scopes AND line MATCHES "${class}|${alias}")
            set(name "${CMAKE_MATCH_4}${CMAKE_MATCH_9}")
            if(CMAKE_MATCH_5 MATCHES "${no_definition}")
                continue()
            endif()
            list(JOIN scopes "" scope)
            string(REPLACE "::" "." name "${scope}${name}")
            if(DEFINED "file_of_${name}" AND NOT "${file_of_${name}}" STREQUAL "${file}")
                string(APPEND doubles "\n  ${name}: ${file_of_${name}} and ${file}")
            endif()
            set("file_of_${name}" "${file}")
        endif()
    endforeach()
    if(scopes)
        message(FATAL_ERROR "${file} does not end its namespaces one by one: ${scopes}")
    endif()
endforeach()
if(doubles)
    message(FATAL_ERROR "Types of one name:${doubles}")
endif()
