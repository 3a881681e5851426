# Compiles everything with the fuzzer's instrumentation, so that the fuzzers of tests/generator/fuzz link the
# rooms as they are.
# SPDX-License-Identifier: GPL-2.0-or-later

if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "HVI_BUILD_FUZZ needs clang, which has libFuzzer")
endif()
add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all)
add_link_options(-fsanitize=address,undefined)
