# Installs hvi with its generator, as it is built in BUILD, looks for what shells and man know of it,
# and has it write the steppers of a project.
# SPDX-License-Identifier: GPL-2.0-or-later

include("${CMAKE_CURRENT_LIST_DIR}/steps.cmake")

run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/installed")
foreach(file IN ITEMS bash-completion/completions/hvi-gen zsh/site-functions/_hvi-gen
        fish/vendor_completions.d/hvi-gen.fish man/man1/hvi-gen.1)
    file(STRINGS "${WORK}/installed/share/${file}" lines REGEX "hvi.*gen")
    if(NOT lines)
        message(FATAL_ERROR "share/${file} says nothing of hvi-gen")
    endif()
endforeach()
build_and_run("${CMAKE_CURRENT_LIST_DIR}/generate" generate -D "CMAKE_PREFIX_PATH=${WORK}/installed")
