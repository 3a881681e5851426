# pages_do_what_they_show.py finds what a page says that is not so, names its line, and is content with
# what differs by rounding alone. In place of hvi-gen stands a program of the shell.
# SPDX-License-Identifier: GPL-2.0-or-later
cmake_minimum_required(VERSION 3.25)

set(fence "```")

# says(status text page): how the look at a page ends, and what it prints then.
function(says status text page)
    file(WRITE "${DIRECTORY}/page.md" "${page}")
    execute_process(
        COMMAND "${PYTHON}" "${SHOWS}" "${DIRECTORY}/page.md" --root "${ROOT}" --hvi-gen /bin/echo
            --directory "${DIRECTORY}/place"
        OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
    if(NOT result EQUAL status OR NOT said MATCHES "${text}")
        message(FATAL_ERROR
            "not ${status} and \"${text}\", but ${result} and\n${said}\nof the page\n${page}")
    endif()
endfunction()

# console(status text shown): the same of a command that prints these words.
function(console status text words shown)
    says(${status} "${text}" "\n${fence}console\n$ hvi-gen ${words}\n${shown}\n${fence}\n")
endfunction()

console(0 "^$" "error 1.12e-11 in 17.5 ns, 0.30 a step" "error 4.4e-12 in 99 ns, 0.301 a step")
console(0 "^$" "kept  to 0" "kept to 0")
console(1 "page.md:3: the block" "error 1.12e-11" "error 1.12e-09")
console(1 "page.md:3: the block" "1000 steps" "1100 steps")
console(1 "page.md:3: the block" "conserved" "not conserved")
console(1 "page.md:3: the block" "one" "one\ntwo")
console(1 "page.md:3: the block" "one; echo two" "one")
console(0 "^$" "one; echo two; echo three" "one\n...\nthree")
console(1 "page.md:3: the block" "one; echo two; echo three" "...\ntwo")
console(1 "ends with status 7" "one; exit 7" "one")
console(0 "^$" "error: one; exit 2" "error: one")

says(0 "^$" "\n${fence}sh\nhvi-gen one\n${fence}\n")
says(1 "page.md:3: the block ends with status 1" "\n${fence}sh\nfalse | cat; false\nhvi-gen one\n${fence}\n")
says(0 "^$" "<!-- not run: it fails -->\n${fence}sh\nfalse\n${fence}\n")
says(0 "^$" "${fence}toml\n# a.toml\nb = 1\n${fence}\n\n${fence}toml\n# added to a.toml\nc = 2\n${fence}\n
${fence}console\n$ cat a.toml\n# a.toml\nb = 1\nc = 2\n${fence}\n")
says(1 "page.md:3: a block by indentation" "Text:\n\n    hvi-gen one\n")
