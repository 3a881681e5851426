# ./dev takes the words that its help has, wherever it is called from, and refuses others with
# status 2 and the names that there are, before it installs or builds anything.
# SPDX-License-Identifier: GPL-2.0-or-later
cmake_minimum_required(VERSION 3.25)

# says(status text word...): how ./dev ends with these words, and what it says then.
function(says status text)
    execute_process(COMMAND "${ROOT}/dev" ${ARGN} WORKING_DIRECTORY "${ROOT}/docs"
        OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
    if(NOT result EQUAL status OR NOT said MATCHES "${text}")
        message(FATAL_ERROR "./dev ${ARGN}: not ${status} and \"${text}\", but ${result} and\n${said}")
    endif()
endfunction()

foreach(word IN ITEMS demo check test packages bench docs help)
    says(0 "\n  ${word} " help)
endforeach()
says(2 "^usage: " nonsense)
says(2 "^error: there is no benchmark nonsense\nhelp: names: .*scenes" bench nonsense)
says(2 "^error: there is no directory of tests nonsense\nhelp: names: .*emit" check nonsense)
says(2 "^error: there is no directory of tests [.][.]\n" check ..)
