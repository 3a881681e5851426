# The text of kernels for a device: it calls nothing that is not in it, and rounds as promised.
# COMPILER with OPTIONS writes the text of ${FILES}_of_sums.cu and ${FILES}_of_functions.cu to OUTPUT.
# SPDX-License-Identifier: GPL-2.0-or-later
cmake_minimum_required(VERSION 3.25)

# refuse(text what pattern), demand(text what pattern): no line is so, or one is.
function(refuse text what pattern)
    string(REGEX MATCH "[^\n]*${pattern}[^\n]*" found "${text}")
    if(found)
        message(FATAL_ERROR "${what}: ${found}")
    endif()
endfunction()

function(demand text what pattern)
    if(NOT text MATCHES "${pattern}")
        message(FATAL_ERROR "no ${what}")
    endif()
endfunction()

foreach(kind IN ITEMS sums functions)
    execute_process(
        COMMAND "${COMPILER}" ${OPTIONS} "${FILES}_of_${kind}.cu" -o "${OUTPUT}_of_${kind}.ptx"
        COMMAND_ERROR_IS_FATAL ANY)
    file(READ "${OUTPUT}_of_${kind}.ptx" ${kind})
    string(REPLACE ";" "," ${kind} "${${kind}}")  # or CMake takes it for a list
    demand("${${kind}}" "kernel" "[.]entry")
    refuse("${${kind}}" "a call of what is not there" "[.]extern [.]func")
    refuse("${${kind}}" "a product that may be fused" "mul[.](ftz[.])?f(32|64)")
    refuse("${${kind}}" "a product and a sum that may be one" "mad[.][a-z.]*f(32|64)")
    refuse("${${kind}}" "a quotient or root that is not rounded" "[.](approx|full)")
    refuse("${${kind}}" "small numbers that become 0" "[.]ftz")
    demand("${${kind}}" "product that is rounded" "mul[.]rn[.]f64")
endforeach()
refuse("${sums}" "a fused product where none is written" "fma[.]")
demand("${sums}" "root that is rounded" "sqrt[.]rn[.]f64")
demand("${sums}" "quotient that is rounded" "div[.]rn[.]f64")
demand("${sums}" "quotient that is rounded, in float" "div[.]rn[.]f32")
demand("${functions}" "fused product" "fma[.]rn[.]f64")
demand("${functions}" "fused product in float" "fma[.]rn[.]f32")
